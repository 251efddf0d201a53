#include "whittle/decimate.hh"

#include "OpenMeshFixture.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModCircumcenterT.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/VertexDistance.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

Mesh torus() {
  return fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.01, 5));
}  // 672 faces
Mesh grid(std::uint32_t n) {
  return fixture::to_openmesh<Mesh>(meshes::flat_grid(n));
}

DecimateOptions to_ratio(double ratio) {
  DecimateOptions options;
  options.ratio = ratio;
  return options;
}

}  // namespace

TEST_CASE("decimate takes an OpenMesh mesh to its target and compacts it") {
  Mesh mesh = torus();
  const DecimateReport report = decimate(mesh, to_ratio(0.25));
  CHECK(report.faces_before == 672);
  CHECK(report.vertices_before == 336);
  CHECK(report.faces == 168);
  CHECK(report.vertices == 84);
  CHECK(report.target_reached);
  CHECK(report.why.empty());
  CHECK(mesh.n_faces() == 168);
  CHECK(mesh.n_vertices() == 84);
  CHECK(mesh.n_edges() == 252);
  CHECK_FALSE(mesh.has_vertex_status());
  CHECK_FALSE(mesh.has_edge_status());
  CHECK_FALSE(mesh.has_face_status());
  REQUIRE(report.vertex_map.size() == 336);
  for (const std::uint32_t v : report.vertex_map) CHECK(v < 84);
}

TEST_CASE("decimate gives arrays and OpenMesh meshes the same surface") {
  const IndexedMeshT<float> arrays = to_indexed(torus());
  Mesh mesh = torus();
  const auto check = [&](const DecimateOptions& options, const auto& planner) {
    Mesh copy = mesh;
    const DecimateReport a = decimate(copy, options, planner);
    const DecimatedT<float> b = decimate(arrays, options, planner);
    CHECK(meshes::canonical(to_indexed(copy)) == meshes::canonical(b.mesh));
    CHECK(a.faces == b.faces);
    CHECK(a.vertices == b.vertices);
    CHECK(a.vertex_map == b.vertex_map);
    CHECK(a.target_reached == b.target_reached);
    CHECK(a.why == b.why);
    CHECK(b.face_origin.size() == b.faces);
    CHECK(b.mesh.triangles.size() == b.faces);
  };
  VertexDistance ivdd;
  ivdd.max_distance = 0.4;
  DecimateOptions vertices;
  vertices.vertices = 100;
  for (const DecimateOptions& options : {to_ratio(0.3), vertices}) {
    check(options, MemorylessQuadric());
    check(options, ivdd);
    check(options, FaceAngle());
  }
  check({}, ivdd);
}

TEST_CASE("decimate keeps what the mesh carries, and the user's own status") {
  Mesh mesh = grid(9);
  mesh.request_vertex_colors();
  mesh.request_vertex_texcoords2D();
  mesh.request_face_normals();
  mesh.request_face_status();
  OpenMesh::VPropHandleT<int> number;
  mesh.add_property(number, "number");
  for (const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    mesh.set_texcoord2D(v, {p[0] / 8, p[1] / 8});
    mesh.set_color(v, Mesh::Color(static_cast<unsigned char>(p[0] * 10), 0, 0));
    mesh.property(number, v) = v.idx();
  }
  mesh.update_face_normals();
  const DecimateReport report = decimate(mesh, to_ratio(0.2));
  CHECK(report.faces == 24);  // of 128; a collapse takes two
  REQUIRE(mesh.n_faces() == 24);
  CHECK(mesh.has_face_status());
  CHECK_FALSE(mesh.has_vertex_status());
  for (const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    CHECK(std::abs(mesh.texcoord2D(v)[0] - p[0] / 8) < 1e-5);
    CHECK(std::abs(mesh.texcoord2D(v)[1] - p[1] / 8) < 1e-5);
    CHECK(std::abs(float(mesh.color(v)[0]) - p[0] * 10) <= 1);
    CHECK(report.vertex_map[static_cast<std::size_t>(mesh.property(number, v))] == std::uint32_t(v.idx()));
  }
  for (const auto f : mesh.faces()) CHECK(std::abs(mesh.normal(f)[2] - 1) < 1e-6);
}

TEST_CASE("decimate locks the boundary, features, and what is selected, locked or a feature") {
  SECTION("the boundary") {
    Mesh mesh = grid(9);
    DecimateOptions options = to_ratio(0.02);
    CHECK(decimate(mesh, options).target_reached);
    CHECK(mesh.n_vertices() == 4);  // a flat square with a straight boundary
    mesh = grid(9);
    options.lock_boundary = true;
    CHECK(decimate(mesh, options).faces == 34);  // 32 held ones, and 2 % of the rest
    mesh = grid(9);
    options.force = true;
    const DecimateReport report = decimate(mesh, options);
    CHECK(report.held == 32);
    CHECK_FALSE(report.target_reached);
    CHECK(report.why.find("32 vertices are locked or features") == 0);
    CHECK(mesh.n_vertices() == 32);
    CHECK(mesh.n_faces() == 30);
  }
  SECTION("features: a roof keeps its ridge") {
    const auto roof = meshes::grid(9, [](auto i, auto) { return 0.5 * std::abs(int(i) - 4); });
    DecimateOptions options;
    options.faces = 1;
    options.lock_feature_angle = 40;
    const auto kept = decimate(roof, options);
    CHECK(kept.held == 9);
    for (std::uint32_t v = 0; v < roof.points.size(); ++v)
      if (roof.points[v][0] == 4) CHECK(kept.mesh.points[kept.vertex_map[v]] == roof.points[v]);
    options.lock_feature_angle = 60;
    CHECK(decimate(roof, options).held == 0);
  }
  SECTION("status") {
    Mesh mesh = torus();
    mesh.request_vertex_status();
    mesh.status(Mesh::VertexHandle(3)).set_locked(true);
    mesh.status(Mesh::VertexHandle(30)).set_feature(true);
    mesh.status(Mesh::VertexHandle(300)).set_selected(true);
    DecimateOptions options = to_ratio(0.1);
    options.lock_selected = true;
    const Mesh before = mesh;
    const DecimateReport report = decimate(mesh, options);
    CHECK(report.held == 3);
    CHECK(mesh.has_vertex_status());
    for (const int v : {3, 30, 300})
      CHECK(mesh.point(Mesh::VertexHandle(int(report.vertex_map[std::size_t(v)]))) ==
            before.point(Mesh::VertexHandle(v)));
  }
}

TEST_CASE("decimate heeds tolerances and weights of vertices, and a largest distance") {
  Mesh mesh = torus();
  OpenMesh::VPropHandleT<float> property;
  mesh.add_property(property);
  const Mesh before = mesh;
  const auto dense_half = [&](Mesh& m, const DecimateOptions& options) {
    decimate(m, options);
    std::size_t n = 0;
    for (const auto v : m.vertices()) n += m.point(v)[0] > 0;
    return double(n) / double(m.n_vertices());
  };
  DecimateOptions options = to_ratio(0.25);
  Mesh even = mesh;
  const double plain = dense_half(even, options);
  for (const auto v : mesh.vertices()) mesh.property(property, v) = mesh.point(v)[0] > 0 ? 0.05f : 1.0f;
  Mesh tolerant = mesh;
  options.tolerance = property;
  const double by_tolerance = dense_half(tolerant, options);
  CHECK(by_tolerance > plain + 0.1);
  for (const auto v : mesh.vertices()) mesh.property(property, v) = mesh.point(v)[0] > 0 ? 400.0f : 1.0f;
  Mesh weighted = mesh;
  options.tolerance = OpenMesh::VPropHandleT<float>();
  options.weight = property;
  CHECK(dense_half(weighted, options) == by_tolerance);

  DecimateOptions bound;
  bound.max_distance = 0.02;
  Mesh near = before;
  const DecimateReport report = decimate(near, bound);
  CHECK(report.target_reached);
  CHECK(report.faces < 672);
  CHECK(report.faces > 50);
  bound.faces = 20;
  near = before;
  const DecimateReport missed = decimate(near, bound);
  CHECK_FALSE(missed.target_reached);
  CHECK(missed.record.refused_by_bound > 0);
  CHECK(missed.why.find(" merges refused by max_distance") != std::string::npos);
}

TEST_CASE("decimate repeats a planner with a threshold until the target is reached") {
  Mesh mesh = torus();
  CHECK(decimate(mesh, to_ratio(0.2), Circumcenter()).faces <= 134);
  Mesh once = torus();
  DecimateOptions options = to_ratio(0.2);
  options.passes = 1;
  const DecimateReport report = decimate(once, options, Circumcenter());
  CHECK_FALSE(report.target_reached);
  CHECK_FALSE(report.why.empty());
}

TEST_CASE("decimate refuses what it cannot do, and leaves the mesh as it was") {
  const Mesh before = torus();
  const auto throws = [&](auto change, auto planner, auto exception) {
    Mesh mesh = before;
    DecimateOptions options;
    change(options, mesh);
    CHECK_THROWS_AS(decimate(mesh, options, planner), decltype(exception));
    CHECK(mesh.n_faces() == 672);
    CHECK_FALSE(mesh.has_edge_status());
  };
  const MemorylessQuadric mq;
  const auto bad = InvalidParameter("");
  const auto early = NotReady("");
  throws([](auto&, auto&) {}, mq, early);
  throws([](auto& o, auto&) { o.ratio = 0.5; }, VertexDistance(), early);
  throws([](auto& o, auto&) { o.ratio = 0; }, mq, bad);
  throws([](auto& o, auto&) { o.ratio = 1.5; }, mq, bad);
  throws([](auto& o, auto&) { o.ratio = std::nan(""); }, mq, bad);
  throws([](auto& o, auto&) { o.faces = 0; }, mq, bad);
  throws([](auto& o, auto&) { o.ratio = 0.5, o.faces = 3; }, mq, bad);
  throws([](auto& o, auto&) { o.max_distance = -1; }, mq, bad);
  throws([](auto& o, auto&) { o.max_distance = 1; }, FaceAngle(), bad);
  throws([](auto& o, auto&) { o.max_distance = std::nan(""); }, FaceAngle(), bad);
  throws([](auto& o, auto&) { o.ratio = 0.5, o.values.normals = -1; }, mq, bad);
  throws([](auto& o, auto&) { o.ratio = 0.5, o.values.colours = 1; }, FaceAngle(), bad);
  throws([](auto& o, auto&) { o.ratio = 0.5, o.lock_feature_angle = 181; }, mq, bad);
  throws([](auto& o, auto&) { o.ratio = 0.5, o.lock_selected = true; }, mq, bad);
  throws(
      [](auto& o, auto& m) {
        o.ratio = 0.5;
        m.add_property(o.weight);
      },
      mq, bad);
  throws(
      [](auto& o, auto& m) {
        o.ratio = 0.5;
        m.set_point(Mesh::VertexHandle(5), {NAN, 0, 0});
      },
      mq, InvalidMesh(""));

  DecimateOptions options = to_ratio(0.5);
  options.lock_selected = true;
  CHECK_THROWS_AS(decimate(meshes::torus(8, 6), options), InvalidParameter);
  SurfaceExtras extras;
  extras.flags = {1, 2, 3};
  CHECK_THROWS_AS(decimate(meshes::torus(8, 6), to_ratio(0.5), MemorylessQuadric(), extras),
                  InvalidParameter);
}

TEST_CASE("decimate takes a mesh without faces, and one with deleted elements") {
  Mesh empty;
  const DecimateReport report = decimate(empty, to_ratio(0.5));
  CHECK(report.faces == 0);
  CHECK(report.target_reached);

  Mesh mesh = torus();
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.delete_vertex(Mesh::VertexHandle(0));
  const DecimateReport half = decimate(mesh, to_ratio(0.5));
  CHECK(half.faces_before == 666);
  CHECK(half.vertices_before == 335);
  CHECK(half.faces <= 333);
  CHECK(half.faces > 330);
  CHECK(mesh.n_faces() == half.faces);
  CHECK(half.vertex_map[0] == DecimateReport::kNoVertex);

  // Nothing depends on where a deleted vertex lies, nor on its properties.
  const auto decimated = [](bool is_odd) {
    Mesh m = torus();
    m.request_vertex_status();
    m.request_edge_status();
    m.request_face_status();
    m.delete_vertex(Mesh::VertexHandle(0));
    OpenMesh::VPropHandleT<float> weight;
    m.add_property(weight);
    for (const auto v : m.all_vertices()) m.property(weight, v) = 1;
    if (is_odd) {
      m.set_point(Mesh::VertexHandle(0), {NAN, 1e30f, 0});
      m.property(weight, Mesh::VertexHandle(0)) = -1;
      m.status(Mesh::VertexHandle(0)).set_selected(true);
    }
    DecimateOptions options;
    options.vertices = 100;
    options.weight = weight;
    options.tolerance = weight;
    options.lock_selected = true;
    const DecimateReport hundred = decimate(m, options);
    CHECK(hundred.vertices == 100);
    CHECK(hundred.record.planned == 235);
    CHECK(hundred.held == 0);
    return to_indexed(m);
  };
  const auto plain = decimated(false), odd = decimated(true);
  CHECK(plain.points == odd.points);
  CHECK(plain.triangles == odd.triangles);
}

namespace {

/// A torus of 672 faces, and twenty small octahedra of 8.
Mesh dusty() {
  std::vector<IndexedMesh> parts = {meshes::shaken(meshes::torus(24, 14), 0.01, 5)};
  for (int i = 0; i < 20; ++i) parts.push_back(meshes::placed(meshes::octahedron(), 0.01, {2.0 + i, 0, 2}));
  return fixture::to_openmesh<Mesh>(meshes::together(parts));
}

}  // namespace

TEST_CASE("decimate lets go of small pieces when asked, and else leaves the rest its share") {
  const auto run = [](const DecimateOptions& options, bool with_deleted = false) {
    Mesh mesh = dusty();
    if (with_deleted) {  // a vertex of a kind that no longer counts
      mesh.request_vertex_status();
      mesh.delete_vertex(mesh.add_vertex({9, 9, 9}));
    }
    const DecimatedT<float> arrays = decimate(to_indexed(dusty()), options);
    DecimateReport report = decimate(mesh, options);
    CHECK(meshes::canonical(to_indexed(mesh)) == meshes::canonical(arrays.mesh));
    CHECK(report.faces == mesh.n_faces());
    CHECK(report.vertices == mesh.n_vertices());
    CHECK(arrays.mesh.triangles.size() == report.faces);
    CHECK(arrays.mesh.points.size() == report.vertices);
    CHECK(arrays.why == report.why);
    CHECK(arrays.pieces_gone == report.pieces_gone);
    if (!with_deleted) CHECK(arrays.vertex_map == report.vertex_map);
    CHECK(arrays.face_origin.size() == report.faces);
    return report;
  };
  DecimateOptions options = to_ratio(0.1);  // 83 faces, and the octahedra hold 80
  const DecimateReport kept = run(options);
  CHECK_FALSE(kept.target_reached);
  CHECK(kept.attainable.is_higher);
  CHECK(kept.attainable.target.faces == 80 + 76);
  CHECK(kept.faces > 150);
  CHECK(kept.faces <= 156);
  CHECK_THAT(kept.why, Catch::Matchers::Contains("20 small pieces keep up to four faces each"));

  options.force = true;
  const DecimateReport forced = run(options);
  CHECK(forced.faces < 100);
  CHECK_THAT(forced.why, Catch::Matchers::Contains("20 small pieces keep up to four faces each"));
  options.force = false;
  options.pieces.by_error = true;
  const DecimateReport gone = run(options);
  CHECK(gone.target_reached);
  CHECK(gone.pieces_gone == 20);
  CHECK(gone.faces > 78);
  for (std::size_t v = 0; v < gone.vertex_map.size(); ++v)
    CHECK((gone.vertex_map[v] == DecimateReport::kNoVertex) == (v >= 336));
  run(options, true);

  options = {};
  options.vertices = 40;
  options.pieces.below = 0.1;
  CHECK(run(options).vertices == 40);
  CHECK(run(options, true).vertices == 40);
  options.pieces.below = -1;
  Mesh mesh = dusty();
  CHECK_THROWS_AS(decimate(mesh, options), InvalidParameter);
  options = {};
  options.max_distance = 0.1;
  options.pieces.by_error = true;
  CHECK_THROWS_AS(decimate(mesh, options), InvalidParameter);
}
