/// \file
/// What is done about meshes that are not as they should be.
#include "files/manifold.hh"
#include "meshes.hh"
#include "samples.hh"
#include "sound.hh"

namespace whittle::files {
namespace {

/// Reads the mesh from a file, with a number for each vertex that travels along.
MeshFile read_with(Repair repair, const IndexedMesh& mesh, const Attributes& more = {}) {
  const Folder folder;
  Attributes attributes = more;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) numbers.push_back(static_cast<float>(i));
  attributes.push_back(scalar("number", numbers));
  write_mesh(folder / "a.ply", mesh, {}, attributes);
  return read_mesh(folder / "a.ply", {repair});
}

std::vector<float> numbers_of(const MeshFile& file) {
  return find(file.attributes, Kind::scalar, "number").values;
}

void check_manifold(const MeshFile& file) {
  CHECK(unsound(file) == nullptr);
  const NonManifold found =
      count_nonmanifold(file.mesh, measure::sides_by_edge(file.mesh.triangles, file.mesh.points.size()));
  CHECK(found.edges == 0);
  CHECK(found.vertices == 0);
}

/// Three pages at one edge.
IndexedMesh book() {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  return mesh;
}

/// Two tetrahedra that share a vertex.
IndexedMesh touching() {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}};
  return mesh;
}

TEST_CASE("repair: none looks for nothing, report counts, fix repairs") {
  const MeshFile none = read_with(Repair::none, book());
  CHECK(none.report.notes().empty());
  CHECK(none.report.repair == Repair::none);
  const MeshFile report = read_with(Repair::report, book());
  CHECK(report.mesh.triangles == book().triangles);
  CHECK(report.report.notes() == Names{"1 non-manifold edge kept"});
  const MeshFile fixed = read_with(Repair::fix, book());
  CHECK(fixed.report.nonmanifold_edges == 1);
  check_manifold(fixed);
}

TEST_CASE("repair: at an edge the first that run against each other stay joined") {
  const MeshFile file = read_with(Repair::fix, book());
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {5, 6, 3}, {1, 0, 4}});
  CHECK(numbers_of(file) == std::vector<float>{0, 1, 2, 3, 4, 0, 1});
  CHECK(file.mesh.points[6] == IndexedMesh::Point(0, 0, 1));
  CHECK(file.report.copied_vertices == 2);
  CHECK(file.report.notes() ==
        Names{"1 non-manifold edge mended", "2 vertices copied where the mesh was cut"});
}

TEST_CASE("repair: fans that share a vertex only get one each") {
  CHECK(read_with(Repair::report, touching()).report.nonmanifold_vertices == 1);
  const MeshFile file = read_with(Repair::fix, touching());
  CHECK(file.report.nonmanifold_vertices == 1);
  CHECK(file.report.copied_vertices == 1);
  CHECK(file.mesh.triangles[4] == IndexedMesh::Triangle{7, 4, 5});
  CHECK(numbers_of(file).back() == 0);
  check_manifold(file);
}

TEST_CASE("repair: two closed bodies that share an edge come apart and stay closed") {
  IndexedMesh mesh = meshes::tetrahedron();
  const auto add = static_cast<std::uint32_t>(mesh.points.size());
  // Another one on the other side of the edge 0 1.
  mesh.points.emplace_back(-5, -5, -5);
  mesh.points.emplace_back(-5, -6, -5);
  mesh.triangles.insert(mesh.triangles.end(),
                        {{0, 1, add}, {1, 0, add + 1}, {0, add, add + 1}, {1, add + 1, add}});
  const MeshFile file = read_with(Repair::fix, mesh);
  CHECK(file.report.nonmanifold_edges == 1);
  CHECK(file.mesh.triangles.size() == 8);
  CHECK(file.mesh.points.size() == 8);
  check_manifold(file);
  for_each_edge(measure::sides_by_edge(file.mesh.triangles, file.mesh.points.size()),
                [](const measure::Side* begin, const measure::Side* end) { CHECK(end - begin == 2); });
}

TEST_CASE("repair: duplicates go, whichever way round they are") {
  IndexedMesh mesh = square();
  mesh.triangles = {{0, 1, 2}, {2, 0, 1}, {0, 2, 3}, {0, 2, 1}};
  const MeshFile report = read_with(Repair::report, mesh);
  CHECK(report.report.duplicate_faces == 2);
  CHECK(report.report.notes().front() == "2 faces on the vertices of an earlier one kept");
  const MeshFile fixed = read_with(
      Repair::fix, mesh,
      {attribute(Kind::texture, 2, {0, 0, 1, 0, 1, 1, 0, 1}, {{0, 1, 2}, {3, 3, 3}, {0, 3, 3}, {2, 2, 2}})});
  CHECK(fixed.mesh.triangles == square().triangles);
  CHECK(fixed.report.duplicate_faces == 2);
  CHECK(fixed.report.notes() == Names{"2 faces on the vertices of an earlier one left out"});
  CHECK(find(fixed.attributes, Kind::texture).corners == Triangles{{0, 1, 2}, {0, 3, 3}});
}

TEST_CASE("repair: faces are turned round to agree, the fewer of a piece") {
  IndexedMesh mesh = meshes::torus(6, 5);
  const Triangles good = mesh.triangles;
  for (const std::size_t face : {0U, 7U, 8U, 30U})
    std::swap(mesh.triangles[face][1], mesh.triangles[face][2]);
  const MeshFile file = read_with(Repair::fix, mesh);
  CHECK(file.mesh.triangles == good);
  CHECK(file.report.turned_faces == 4);
  CHECK(file.report.copied_vertices == 0);
  CHECK(file.report.notes().back() == "4 faces turned round to agree with the neighbours");
  check_manifold(file);
}

TEST_CASE("repair: corners turn with their face") {
  IndexedMesh mesh = square();
  mesh.triangles = {{0, 1, 2}, {0, 3, 2}};
  const MeshFile file =
      read_with(Repair::fix, mesh,
                {attribute(Kind::texture, 2, {0, 0, 1, 0, 1, 1, 0, 1, 5, 5}, {{0, 1, 2}, {0, 3, 4}})});
  CHECK(file.mesh.triangles == square().triangles);
  CHECK(find(file.attributes, Kind::texture).corners == Triangles{{0, 1, 2}, {0, 3, 4}});
  CHECK(find(file.attributes, Kind::texture).values == std::vector<float>{0, 0, 1, 0, 1, 1, 5, 5, 0, 1});
}

TEST_CASE("repair: a Moebius strip is cut open") {
  IndexedMesh mesh;
  constexpr std::uint32_t n = 7;
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.points.emplace_back(i, 0, 0);
    mesh.points.emplace_back(i, 1, 0);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t a = 2 * i, b = 2 * i + 1, c = (2 * i + 2) % (2 * n), d = (2 * i + 3) % (2 * n);
    if (i + 1 == n) std::swap(c, d);
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({b, c, d});
  }
  const MeshFile file = read_with(Repair::fix, mesh);
  CHECK(file.report.nonmanifold_edges == 1);
  CHECK(file.mesh.triangles.size() == 2 * n);
  CHECK(file.mesh.points.size() == 2 * n + 2);
  check_manifold(file);
}

TEST_CASE("repair: a fin between two vertices that stay joined is parted from its neighbours") {
  // A grid with one more face on the edge between two inner vertices, connected with nothing else; and one
  // the same way round as the grid's, so that it cannot be joined anywhere.
  IndexedMesh mesh = meshes::grid(5, [](auto, auto) { return 0.0; });
  mesh.points.emplace_back(2, 2, 3);
  const auto tip = static_cast<std::uint32_t>(mesh.points.size() - 1);
  mesh.triangles.push_back({12, 13, tip});
  mesh.triangles.push_back({13, 12, tip});  // a duplicate of it
  mesh.triangles.push_back({12, 13, 0});
  const MeshFile file = read_with(Repair::fix, mesh);
  CHECK(file.report.duplicate_faces == 1);
  CHECK(file.mesh.triangles.size() == mesh.triangles.size() - 1);
  check_manifold(file);
}

TEST_CASE("repair: vertices of no face go, but not those of a cloud") {
  IndexedMesh mesh = square();
  mesh.points.insert(mesh.points.begin(), {9, 9, 9});
  mesh.triangles = {{1, 2, 3}};
  CHECK(read_with(Repair::report, mesh).mesh.points.size() == 5);
  const MeshFile file = read_with(Repair::fix, mesh);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(numbers_of(file) == std::vector<float>{1, 2, 3});
  CHECK(file.report.dropped_vertices == 2);
  CHECK(file.report.notes() == Names{"2 vertices not finite or of no face left out"});
  mesh.triangles.clear();
  CHECK(read_with(Repair::fix, mesh).mesh.points.size() == 5);
}

TEST_CASE("repair: faces that use what is broken go, in every format") {
  const Folder folder;
  struct Sample {
    const char* name;
    const char* text;
  };
  // The first face names a vertex that is missing, the second one that is not finite, the third is good.
  const Sample samples[] = {
      {"a.obj",
       "f 1 2 9\nf -1 -2 -3\nv 0 0 0\nv 1 0 nan\nv 0 1 0\nv 5 5 5\nvt 0 0\nf 1/1 2/1 3/1\nf 1/1 3/7 4/1\nf 0 "
       "1 2\nf 1 2\n"},
      {"a.off", "OFF\n4 5 0\n0 0 0\n1 0 inf\n0 1 0\n5 5 5\n3 0 1 8\n3 0 1 -1\n3 0 1 2\n3 0 2 3\n2 0 1\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 5\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 nan\n0 1 0\n5 5 5\n"
       "3 0 1 8\n3 0 1 -1\n3 0 1 2\n3 0 2 3\n2 0 1\n"}};
  for (const Sample& sample : samples) {
    INFO(sample.name);
    CHECK_FALSE(folder.error(sample.name, sample.text).empty());
    CHECK_FALSE(folder.error(sample.name, sample.text, Repair::none).empty());
    const MeshFile file = folder.read(sample.name, sample.text, Repair::fix);
    CHECK(file.mesh.points == std::vector<IndexedMesh::Point>{{0, 0, 0}, {0, 1, 0}, {5, 5, 5}});
    CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
    CHECK(file.report.broken_faces == (std::string(sample.name) == "a.obj" ? 5 : 4));
    CHECK(file.report.dropped_vertices == 1);
    CHECK(unsound(file) == nullptr);
  }
  const MeshFile stl = folder.read("a.stl",
                                   "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex nan 0 0\n"
                                   "vertex 0 1 0\nendloop\nendfacet\nendsolid\n",
                                   Repair::fix);
  CHECK(stl.mesh.triangles.empty());
  CHECK(stl.report.broken_faces == 1);
}

TEST_CASE("repair: values at corners when no face is left") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.obj", "v nan 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvt 2 2\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2\n",
      Repair::fix);
  CHECK(file.mesh.triangles.empty());
  CHECK(file.mesh.points.size() == 3);
  CHECK(file.attributes.at(0).values == std::vector<float>(6));
  CHECK(unsound(file) == nullptr);
}

TEST_CASE("repair: of a polygon the triangles that use nothing broken stay") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 9\n", Repair::fix);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(file.report.broken_faces == 1);
  CHECK(file.report.polygons == 1);
}

TEST_CASE("repair: random soups come out manifold, and say the same every time") {
  std::mt19937 random(11);
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  for (int round = 0; round < 300; ++round) {
    IndexedMesh mesh;
    const std::uint32_t vertices = 4 + below(9);
    for (std::uint32_t i = 0; i < vertices; ++i) mesh.points.emplace_back(i, below(7), below(5));
    for (std::uint32_t i = 0; i < 3 * vertices; ++i) {
      const std::uint32_t a = below(vertices), b = below(vertices), c = below(vertices);
      if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
    }
    const MeshFile file = read_with(Repair::fix, mesh);
    check_manifold(file);
    CHECK(file.mesh.triangles.size() + file.report.duplicate_faces == mesh.triangles.size());
    const std::vector<float> numbers = numbers_of(file);
    for (std::size_t i = 0; i < file.mesh.points.size(); ++i)
      CHECK(file.mesh.points[i] == mesh.points[static_cast<std::size_t>(numbers[i])]);
    CHECK(read_with(Repair::fix, mesh).mesh.triangles == file.mesh.triangles);
  }
}

TEST_CASE("repair: a good mesh comes through as it is") {
  const IndexedMesh torus = meshes::torus(12, 8);
  const MeshFile file = read_with(Repair::fix, torus);
  CHECK(same_bits<double>(file.mesh, torus));
  CHECK(file.report.notes().empty());
}

}  // namespace
}  // namespace whittle::files
