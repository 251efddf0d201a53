/// \file
/// Vertices at one place, in files that double them along seams and creases.
#include "files/join.hh"

#include <array>
#include <random>

#include "files/manifold.hh"
#include "meshes.hh"
#include "samples.hh"
#include "sound.hh"

namespace whittle::files {
namespace {

/// Every face with vertices of its own.
IndexedMesh soup_of(const IndexedMesh& mesh) {
  IndexedMesh soup;
  for (const IndexedMesh::Triangle& triangle : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : triangle) soup.points.push_back(mesh.points[corner]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

void append(IndexedMesh& mesh, const IndexedMesh& more, const IndexedMesh::Point& offset = {0, 0, 0}) {
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  for (const IndexedMesh::Point& point : more.points) mesh.points.push_back(point + offset);
  for (const auto& [a, b, c] : more.triangles) mesh.triangles.push_back({n + a, n + b, n + c});
}

MeshFile joined(const IndexedMesh& mesh, double weld = 0) {
  MeshFile file;
  file.mesh = mesh;
  join(file, {weld});
  return file;
}

struct Edges {
  std::size_t open = 0, complex = 0;
};
Edges edges_of(const IndexedMesh& mesh) {
  Edges edges;
  for_each_edge(measure::sides_by_edge(mesh.triangles, mesh.points.size()),
                [&](const measure::Side* begin, const measure::Side* end) {
                  edges.open += end - begin == 1;
                  edges.complex += end - begin > 2;
                });
  return edges;
}

NonManifold nonmanifold(const IndexedMesh& mesh) {
  return count_nonmanifold(mesh, measure::sides_by_edge(mesh.triangles, mesh.points.size()));
}

void check_manifold_and_closed(const IndexedMesh& mesh) {
  CHECK(edges_of(mesh).open == 0);
  CHECK(nonmanifold(mesh).edges == 0);
  CHECK(nonmanifold(mesh).vertices == 0);
}

/// The cube between (0, 0, 0) and (1, 1, 1).
IndexedMesh box() {
  IndexedMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A scalar that has another value on each face.
Attribute face_numbers(const IndexedMesh& mesh) {
  Attribute number = scalar("face", {});
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    number.values.push_back(static_cast<float>(face));
    number.corners.push_back({face, face, face});
  }
  return number;
}

/// square() with its diagonal doubled: the second face has vertices of its own.
const char* const kDoubledSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0.5\n";

}  // namespace

TEST_CASE("join: doubled vertices of OBJ, PLY and OFF become one, and the file's have their places") {
  const Folder folder;
  const std::string faces = "3 0 1 2\n3 3 4 5\n";
  std::string points = kDoubledSquare;
  for (std::size_t at; (at = points.find("v ")) != std::string::npos;) points.erase(at, 2);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string body = points.append(faces);
  for (const MeshFile& file :
       {folder.read("a.obj", std::string(kDoubledSquare) + "f 1 2 3\nf 4 5 6\n"),
        folder.read("a.ply", ply + body), folder.read("a.off", "OFF\n6 2 0\n" + body)}) {
    INFO(file.report.format);
    CHECK(file.mesh.triangles == square().triangles);
    CHECK(file.mesh.points == square().points);
    CHECK(file.vertex_of == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
    CHECK(file.report.notes() == Names{"2 vertices joined with others at the same place"});
  }
  const MeshFile none =
      folder.read("a.obj", std::string(kDoubledSquare) + "f 1 2 3\nf 4 5 6\n", Repair::none);
  CHECK(none.mesh.points.size() == 6);
  CHECK(none.report.notes().empty());
  CHECK(none.vertex_of.empty());
}

TEST_CASE("join: attributes that differ are at the corners, others at the vertices") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "property float s\nproperty float t\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property float quality\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 255 0 0 1\n1 0 0 1 0 255 0 0 2\n1 1 0 1 1 255 0 0 3\n"
      "0 0 0 5 5 255 0 0 1\n1 1 0 6 6 255 0 0 7\n0 1 0.5 5 6 255 0 0 4\n"
      "3 0 1 2\n3 3 4 5\n");
  CHECK(unsound(file) == nullptr);
  CHECK(file.mesh.points.size() == 4);
  CHECK(file.texture_at_vertices);
  const Attribute& texture = find(file.attributes, Kind::texture);
  CHECK(texture.corners == Triangles{{0, 1, 2}, {3, 4, 5}});
  CHECK(texture.values == std::vector<float>{0, 0, 1, 0, 1, 1, 5, 5, 6, 6, 5, 6});
  CHECK(find(file.attributes, Kind::colour).per_vertex());
  CHECK(find(file.attributes, Kind::scalar, "quality").values == std::vector<float>{1, 2, 3, 7, 4});
  CHECK(find(file.attributes, Kind::scalar, "quality").corners == Triangles{{0, 1, 2}, {0, 3, 4}});
}

TEST_CASE("join: a file is written with the vertices doubled that it has been read with") {
  const Folder folder;
  const Attributes all{attribute(Kind::normal, 3, {0, 0, 1, 0, 1, 0}, {{0, 0, 0}, {1, 1, 1}}), square_seam()};
  WriteOptions options;
  options.texture_at_vertices = true;
  const WriteReport report = write_mesh(folder / "a.ply", square(), options, all);
  CHECK(report.doubled_vertices == 2);
  CHECK(report.first_vertex == std::vector<std::uint32_t>{0, 2, 3, 5});
  CHECK(report.notes() == Names{"2 vertices written again for values that differ at their corners"});
  CHECK(read_mesh(folder / "a.ply", {Repair::none}).mesh.points.size() == 6);
  const MeshFile back = read_mesh(folder / "a.ply");
  CHECK(back.mesh.triangles == square().triangles);
  CHECK(back.texture_at_vertices);
  for (const Attribute& one : all) CHECK(same_attribute(find(back.attributes, one.kind), one, square()));

  options.texture_at_vertices = false;  // a list at each face takes no more vertices
  CHECK(write_mesh(folder / "b.ply", square(), options, {square_seam()}).doubled_vertices == 0);
  CHECK_FALSE(read_mesh(folder / "b.ply").texture_at_vertices);
  // GLB doubles vertices in any case, and says which is which.
  const WriteReport of_glb = write_mesh(folder / "a.glb", square(), {}, {square_seam()});
  CHECK(of_glb.first_vertex == std::vector<std::uint32_t>{0, 2, 3, 5});
  CHECK(of_glb.doubled_vertices == 2);
  const Level level{square(), {square_seam()}};
  CHECK(write_levels(folder / "b.glb", {level, level}).doubled_vertices == 4);
}

TEST_CASE("join: closed surfaces of faces on their own are closed again") {
  for (const IndexedMesh& mesh : {meshes::tetrahedron(), meshes::torus(7, 5)}) {
    const MeshFile file = joined(soup_of(mesh));
    CHECK(file.mesh.points.size() == mesh.points.size());
    CHECK(file.report.merged_vertices == 3 * mesh.triangles.size() - mesh.points.size());
    check_manifold_and_closed(file.mesh);
  }
}

TEST_CASE("join: bodies that touch at a vertex or along an edge stay two") {
  const IndexedMesh one = meshes::tetrahedron();
  const IndexedMesh::Point corner = one.points[one.triangles[0][0]];
  IndexedMesh other = one;  // the same turned about its first vertex
  for (IndexedMesh::Point& point : other.points) point = 2 * corner - point;
  for (IndexedMesh::Triangle& triangle : other.triangles) std::swap(triangle[1], triangle[2]);
  for (const bool as_soup : {false, true}) {
    IndexedMesh both = as_soup ? soup_of(one) : one;
    append(both, as_soup ? soup_of(other) : other);
    const MeshFile file = joined(both);
    CHECK(file.mesh.points.size() == 8);
    CHECK(file.report.vertices_apart == 2);
    check_manifold_and_closed(file.mesh);
  }

  // Turned by half a turn about an edge: four faces meet there.
  const IndexedMesh::Point a = one.points[one.triangles[0][0]],
                           along = (one.points[one.triangles[0][1]] - a).normalized();
  IndexedMesh beside = one;
  for (std::uint32_t v = 0; v < beside.points.size(); ++v) {
    if (v == one.triangles[0][0] || v == one.triangles[0][1]) continue;
    const IndexedMesh::Point d = one.points[v] - a;
    beside.points[v] = a + 2 * d.dot(along) * along - d;
  }
  for (const bool as_soup : {false, true}) {
    IndexedMesh both = as_soup ? soup_of(one) : one;
    append(both, as_soup ? soup_of(beside) : beside);
    const MeshFile file = joined(both);
    CHECK(file.mesh.points.size() == 8);
    check_manifold_and_closed(file.mesh);
  }
}

TEST_CASE(
    "join: bodies in STL and GLB files that touch at a vertex or along an edge stay two, and are closed") {
  // Two tetrahedra that share the place of their first vertex, two boxes that share those of an edge.
  IndexedMesh tetrahedra = meshes::tetrahedron(), turned = tetrahedra;
  for (IndexedMesh::Point& point : turned.points) point = -point;
  for (IndexedMesh::Triangle& triangle : turned.triangles) std::swap(triangle[1], triangle[2]);
  append(tetrahedra, turned);
  IndexedMesh boxes = box();
  append(boxes, box(), {1, 1, 0});
  const Folder folder;
  for (const auto& [mesh, apart] : {std::pair(tetrahedra, 2U), std::pair(boxes, 4U)}) {
    // GLB as most exporters write it: each face with vertices of its own, for its normal.
    write_mesh(folder / "a.glb", mesh, {}, {face_numbers(mesh)});
    write_mesh(folder / "b.glb", mesh);
    write_mesh(folder / "c.stl", mesh);
    WriteOptions text;
    text.ascii = true;
    write_mesh(folder / "d.stl", mesh, text);
    for (const char* name : {"a.glb", "b.glb", "c.stl", "d.stl"}) {
      for (const Repair repair : {Repair::none, Repair::report, Repair::fix}) {
        const MeshFile file = read_mesh(folder / name, {repair});
        INFO(name << ", repair " << to_string(repair));
        CHECK(file.mesh.points.size() == mesh.points.size());
        CHECK(file.mesh.triangles.size() == mesh.triangles.size());
        CHECK(file.report.vertices_apart == apart);
        CHECK(file.report.copied_vertices == 0);
        CHECK(unsound(file) == nullptr);
        check_manifold_and_closed(file.mesh);
      }
    }
  }
}

TEST_CASE("join: a seam that a GLB file doubles is one edge, with what differs at its corners") {
  const Folder folder;
  Attribute texture = square_seam();
  texture.downwards = true;
  write_mesh(folder / "a.glb", square(), {}, {texture});
  const MeshFile file = read_mesh(folder / "a.glb");
  CHECK(file.mesh.points == square().points);
  CHECK(file.mesh.triangles == square().triangles);
  CHECK(file.vertex_of == std::vector<std::uint32_t>{0, 0, 1, 2, 2, 3});
  CHECK(file.report.notes() == Names{"2 vertices joined with others at the same place"});
  REQUIRE(file.attributes.size() == 1);
  CHECK(same_attribute(file.attributes[0], texture, square()));
  CHECK_FALSE(file.attributes[0].per_vertex());
}

TEST_CASE("join: of STL, faces that lie on one another or are turned round meet for the repair to mend") {
  const Folder folder;
  IndexedMesh mesh = meshes::tetrahedron();
  std::swap(mesh.triangles[3][1], mesh.triangles[3][2]);  // turned round
  mesh.triangles.push_back(mesh.triangles[0]);            // twice, both ways round
  mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][2], mesh.triangles[0][1]});
  write_mesh(folder / "a.stl", mesh);
  const MeshFile report = read_mesh(folder / "a.stl");
  CHECK(report.mesh.points.size() == 4);
  CHECK(report.mesh.triangles.size() == 6);
  CHECK(report.report.duplicate_faces == 2);
  CHECK(report.report.nonmanifold_edges ==
        5);  // three of the face that is there thrice, two of the turned one
  CHECK(report.vertex_of.empty());
  const MeshFile fixed = read_mesh(folder / "a.stl", {Repair::fix});
  CHECK(fixed.mesh.points.size() == 4);
  CHECK(fixed.mesh.triangles.size() == 4);
  CHECK(fixed.report.turned_faces == 1);
  check_manifold_and_closed(fixed.mesh);
}

TEST_CASE("join: the front and the back of a sheet stay two") {
  IndexedMesh front = meshes::flat_grid(3), back = front;
  for (IndexedMesh::Triangle& triangle : back.triangles) std::swap(triangle[1], triangle[2]);
  IndexedMesh both = front;
  append(both, back);
  CHECK(joined(both).mesh.points.size() == both.points.size());
  IndexedMesh soup = soup_of(front);
  append(soup, soup_of(back));
  const MeshFile file = joined(soup);
  CHECK(file.mesh.points.size() == both.points.size());
  CHECK(nonmanifold(file.mesh).edges == 0);
  CHECK(nonmanifold(file.mesh).vertices == 0);
  CHECK(edges_of(file.mesh).open == 2 * edges_of(front).open);
}

TEST_CASE("join: at a T a sheet that goes straight on stays whole, the other one ends there") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  mesh.triangles = {{1, 0, 4}, {1, 0, 2}, {0, 1, 3}};
  const MeshFile file = joined(soup_of(mesh));
  CHECK(file.mesh.points.size() == 7);
  CHECK(file.mesh.triangles[2] ==
        IndexedMesh::Triangle{file.mesh.triangles[1][1], file.mesh.triangles[1][0], 6});
  CHECK(nonmanifold(file.mesh).edges == 0);
}

TEST_CASE("join: faces of opposite orientation stay open and are named, or are joined to be turned") {
  IndexedMesh mesh = square();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  const Folder folder;
  write_mesh(folder / "a.ply", soup_of(mesh));
  const MeshFile report = read_mesh(folder / "a.ply");
  CHECK(report.mesh.points.size() == 6);
  CHECK(report.report.edges_left_open == 1);
  CHECK(report.report.nonmanifold_edges == 0);
  const MeshFile fixed = read_mesh(folder / "a.ply", {Repair::fix});
  CHECK(fixed.mesh.points.size() == 4);
  CHECK(fixed.report.turned_faces == 1);
  CHECK(nonmanifold(fixed.mesh).edges == 0);
}

TEST_CASE("join: a face between doubled vertices goes as they become one") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};  // 0 1 2 has no area
  const MeshFile file = joined(mesh);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 3, 1}});
  CHECK(file.report.dropped_degenerate == 1);
  // Two vertices on the boundary that would be the only thing that holds two parts together stay two.
  mesh.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  CHECK(joined(mesh).mesh.triangles.empty());
  mesh.points.insert(mesh.points.end(), {{1, 1, 0}, {-1, 1, 0}});
  mesh.triangles.insert(mesh.triangles.end(), {{1, 4, 2}, {1, 5, 3}});
  CHECK(joined(mesh).mesh.triangles == mesh.triangles);
}

TEST_CASE("join: what is not manifold in the file stays as it is") {
  IndexedMesh book;
  book.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  book.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  CHECK(joined(book).mesh.triangles == book.triangles);
  append(book, IndexedMesh(book));
  const MeshFile file = joined(book);
  CHECK(file.mesh.triangles == book.triangles);
  CHECK(nonmanifold(file.mesh).edges == 2);
}

TEST_CASE(
    "join: random faces on a few places stay manifold where they were, and none is lost that has an area") {
  std::mt19937 random(1);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  std::size_t joins = 0;
  for (int round = 0; round < 3000; ++round) {
    // Faces at random places that share some of their vertices, without those that would not be manifold.
    IndexedMesh mesh;
    const std::uint32_t places = 4 + below(5);
    for (std::uint32_t face = 0; face < 3 + below(12); ++face) {
      std::array<std::uint32_t, 3> at{below(places), below(places), below(places)};
      IndexedMesh::Triangle triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto n = static_cast<std::uint32_t>(mesh.points.size());
        const IndexedMesh::Point point(at[k] % 3, at[k] / 3, at[k] % 2);
        triangle[k] = n;
        for (std::uint32_t v = 0; v < n; ++v)
          if (mesh.points[v] == point && below(3) == 0) triangle[k] = v;
        if (triangle[k] == n) mesh.points.push_back(point);
      }
      if (measure::has_vertex_twice(triangle)) continue;
      mesh.triangles.push_back(triangle);
      if (nonmanifold(mesh).edges + nonmanifold(mesh).vertices > 0) mesh.triangles.pop_back();
    }
    const MeshFile file = joined(mesh);
    INFO(round);
    CHECK(nonmanifold(file.mesh).edges == 0);
    CHECK(nonmanifold(file.mesh).vertices == 0);
    CHECK(unsound(file) == nullptr);
    CHECK(file.mesh.triangles.size() + file.report.dropped_degenerate == mesh.triangles.size());
    joins += file.report.merged_vertices;
  }
  CHECK(joins > 3000);
}

TEST_CASE("join: within a length the first vertex's coordinates are taken, and a chain is one") {
  IndexedMesh mesh = soup_of(square());
  mesh.points[3].x() = 0.004;  // of 0, 0, 0
  mesh.points[4].z() = 0.004;
  CHECK(joined(mesh).mesh.points.size() == 6);
  const MeshFile file = joined(mesh, 0.005);
  CHECK(file.mesh.points == square().points);
  CHECK(file.mesh.triangles == square().triangles);
  CHECK(joined(mesh, 0.0039).mesh.points.size() == 6);

  mesh = square();
  mesh.points = {{0, 0, 0},    {1, 0, 0},    {1, 1, 0},   {0, 1, 0.5},
                 {1.01, 0, 0}, {1.02, 0, 0}, {2, 0.5, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {4, 5, 7}, {5, 6, 7}};
  const MeshFile chain = joined(mesh, 0.012);
  CHECK(chain.vertex_of == std::vector<std::uint32_t>{0, 1, 2, 3, 1, 1, 4, 2});
  CHECK(chain.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}});
}

TEST_CASE("join: a weld that is no length, or too long, is refused") {
  const Folder folder;
  folder.put("a.obj", std::string(kDoubledSquare) + "f 1 2 3\nf 4 5 6\n");
  const auto error = [&](double weld) {
    return folder.message([&] { read_mesh(folder / "a.obj", {Repair::report, weld}); });
  };
  CHECK(error(0.014).empty());
  CHECK(error(0.016) ==
        "a.obj: a weld of 0.016 would join more than details: it may be at most 0.015, 1 % of the bounding "
        "box's "
        "diagonal");
  CHECK(error(-1) == "a.obj: the weld must be a length, not negative");
  CHECK(error(HUGE_VAL) == error(-1));
  CHECK(error(std::nan("")) == error(-1));
}

TEST_CASE("join: faces that stand alone are counted where nearly all do") {
  const Folder folder;
  IndexedMesh soup = soup_of(meshes::torus(6, 5));
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i].x() += 1e-6 * static_cast<double>(i);
  write_mesh(folder / "a.stl", rounded(soup));
  const MeshFile alone = read_mesh(folder / "a.stl");
  CHECK(alone.report.lone_faces == 60);
  CHECK(alone.report.notes() ==
        Names{"60 faces stand alone; if neighbours lie near one another, --weld LENGTH joins them"});
  const MeshFile welded = read_mesh(folder / "a.stl", {Repair::report, 2e-4});
  CHECK(welded.report.lone_faces == 0);
  CHECK(welded.mesh.points.size() == 30);
  check_manifold_and_closed(welded.mesh);
}

TEST_CASE("join: the file's vertices keep their places through a repair") {
  const Folder folder;
  // 0 is of no face, 1 and 4 are at one place, and three faces meet at the edge 1 2.
  const MeshFile file =
      folder.read("a.obj",
                  "v 9 9 9\nv 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 0 0\nv 0 1 0\nv -1 0 0\nv 0 0 1\n"
                  "f 2 3 4\nf 2 3 6\nf 8 5 7\n",
                  Repair::fix);
  CHECK(file.vertex_of.at(0) == MeshFile::left_out);
  const std::vector<IndexedMesh::Point> at = {{9, 9, 9}, {0, 0, 0}, {0, 0, 1},  {1, 0, 0},
                                              {0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  REQUIRE(file.vertex_of.size() == at.size());
  for (std::size_t v = 1; v < at.size(); ++v) CHECK(file.mesh.points[file.vertex_of[v]] == at[v]);
  CHECK(nonmanifold(file.mesh).edges == 0);
}

}  // namespace whittle::files
