#include "whittle/join_doubled.hh"

#include <limits>

#include "OpenMeshFixture.hh"
#include "charts.hh"
#include "whittle/decimate.hh"

using namespace whittle;
using fixture::Mesh;
using meshes::IndexedMesh;

namespace {

/// A mesh whose vertices come once for each chart around them, and a value for each: the chart.
struct CutMesh {
  IndexedMesh mesh;
  std::vector<float> chart;
};

CutMesh cut_along(const IndexedMesh& whole, const std::vector<std::uint32_t>& chart) {
  CutMesh out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f) {
    auto& corners = out.mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = whole.triangles[f][k];
      const auto fresh = static_cast<std::uint32_t>(out.chart.size());
      const auto [found, is_new] = known.emplace(std::pair(v, chart[f]), fresh);
      corners[k] = found->second;
      if (!is_new) continue;
      out.mesh.points.push_back(whole.points[v]);
      out.chart.push_back(static_cast<float>(chart[f]));
    }
  }
  return out;
}

IndexedMesh made_of(std::vector<IndexedMesh::Point> points, std::vector<IndexedMesh::Triangle> triangles) {
  IndexedMesh mesh;
  mesh.points = std::move(points);
  mesh.triangles = std::move(triangles);
  return mesh;
}

/// Two triangles on either side of the edge from (0, 0) to (1, 0), each with vertices of its own.
IndexedMesh two_triangles() {
  return made_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}});
}

IndexedMesh shaken_torus() {
  return meshes::shaken(meshes::torus(32, 16), 0.01, 5);  // 1024 faces
}

std::size_t open_edges(const Mesh& mesh) {
  std::size_t n = 0;
  for (const auto e : mesh.edges()) n += mesh.is_boundary(e);
  return n;
}

}  // namespace

TEST_CASE("join_doubled: two faces at one edge get its vertices, and a wedge for each value") {
  const IndexedMesh mesh = two_triangles();
  for (const double zero : {0.0, -0.0}) {
    IndexedMesh signed_zero = mesh;
    signed_zero.points[4].x() = zero;
    const auto joined = join_doubled(signed_zero);
    CHECK(joined.mesh.triangles == std::vector<IndexedMesh::Triangle>{{0, 1, 2}, {1, 0, 3}});
    CHECK(joined.mesh.points == std::vector<IndexedMesh::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
    CHECK(joined.vertex_map == std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3});
    CHECK(joined.joined == 2);
    CHECK(joined.wedges == std::vector<IndexedMesh::Triangle>{{0, 1, 2}, {1, 0, 5}});
  }
  const auto joined = join_doubled(mesh, {1, 0, 2, 0, 3, 0, 2, 0.5f, 1, 0, 4, 0}, 2);
  CHECK(joined.wedges == std::vector<IndexedMesh::Triangle>{{0, 1, 2}, {3, 0, 5}});
}

TEST_CASE("join_doubled: what is not a pair of open edges that run against each other stays apart") {
  const auto stays = [](const IndexedMesh& mesh) {
    const auto joined = join_doubled(mesh);
    CHECK(joined.joined == 0);
    CHECK(joined.mesh.points == mesh.points);
    CHECK(joined.mesh.triangles == mesh.triangles);
  };
  stays(meshes::torus(8, 6));
  stays({});
  IndexedMesh mesh = two_triangles();
  mesh.triangles[1] = {4, 3, 5};  // the same direction
  stays(mesh);
  mesh = two_triangles();
  mesh.points[5] = mesh.points[2];  // the back of the first
  stays(mesh);
  mesh = two_triangles();
  mesh.points[4].y() = 1e-300;  // not exactly there
  stays(mesh);
  mesh.points[4].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(join_doubled(mesh).joined == 0);
  // A third one at the edge.
  mesh = two_triangles();
  for (const auto& p : {mesh.points[3], mesh.points[4], IndexedMesh::Point(0, 0, 1)})
    mesh.points.push_back(p);
  mesh.triangles.push_back({6, 7, 8});
  stays(mesh);
  // Faces that touch in a vertex only.
  stays(
      made_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}));
}

TEST_CASE("join_doubled: no edge gets a third face") {
  // Two pairs of faces lie at the edge from 0 to 1, each with vertices of its own; the one goes up and down to 2 and 3,
  // the other to 4 and 5. A sheet from 2 to 5 hangs together with both at either end of the edge.
  const std::vector<IndexedMesh::Point> at = {{0, 0, 0},  {1, 0, 0},  {0, 1, 1},
                                              {0, 1, -1}, {0, -1, 1}, {0, -1, -1}};
  const IndexedMesh mesh = made_of(
      {at[0], at[1], at[2], at[3], at[0], at[1], at[4], at[5], at[0], at[2], at[5], at[1], at[5], at[2]},
      {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}, {5, 4, 7}, {8, 9, 10}, {11, 12, 13}});
  const auto joined = join_doubled(mesh);
  CHECK(joined.joined > 0);
  CHECK(meshes::nonmanifold_edges(joined.mesh) == 0);
  // Without the sheet's second half the pairs meet in one vertex only.
  IndexedMesh half = mesh;
  half.triangles.pop_back();
  CHECK(join_doubled(half).vertex_map ==
        std::vector<std::uint32_t>{0, 1, 2, 3, 0, 4, 5, 6, 0, 2, 6, 7, 8, 9});
}

TEST_CASE("join_doubled: no face loses its area") {
  // Face 0 has the corners 0 and 1 at one place, and the faces around it meet there.
  const IndexedMesh mesh = made_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {-1, -1, 0}},
                                   {{0, 1, 2}, {2, 1, 3}, {3, 1, 4}, {0, 2, 5}});
  CHECK(join_doubled(mesh).joined == 0);
}

TEST_CASE(
    "join_doubled: a torus that was cut into charts is whole again, and stays closed when it is decimated") {
  const IndexedMesh whole = shaken_torus();
  for (const std::size_t size : {1u, 7u, 100u}) {
    const auto chart = meshes::grown_charts(whole, size, 2);
    const CutMesh parts = cut_along(whole, chart);
    REQUIRE(parts.mesh.points.size() > whole.points.size());
    const auto joined = join_doubled(parts.mesh, parts.chart, 1);
    CHECK(joined.mesh.points.size() == whole.points.size());
    CHECK(joined.joined == parts.mesh.points.size() - whole.points.size());
    CHECK(meshes::canonical(joined.mesh) == meshes::canonical(whole));
    CHECK(charts(joined.mesh.triangles, joined.wedges).count ==
          charts(whole.triangles, meshes::wedges_of(whole, chart)).count);

    DecimateOptions options;
    options.ratio = 0.5;
    SurfaceExtras extras;
    extras.wedges = joined.wedges;
    const auto small = decimate(joined.mesh, options, MemorylessQuadric(), extras);
    CHECK(small.target_reached);
    CHECK(small.charts > 0);
    CHECK(small.doubled == 0);
    CHECK(open_edges(fixture::to_openmesh<Mesh>(small.mesh)) == 0);

    const auto torn = decimate(parts.mesh, options);
    CHECK(torn.doubled > joined.joined);
    Mesh mesh = fixture::to_openmesh<Mesh>(parts.mesh);
    CHECK(decimate(mesh, options).doubled == torn.doubled);
  }
}

TEST_CASE("join_doubled: a target that doubled vertices hold up says so") {
  const CutMesh parts = cut_along(shaken_torus(), meshes::grown_charts(shaken_torus(), 1, 2));
  DecimateOptions options;
  options.faces = 100;
  const auto held = decimate(parts.mesh, options);
  CHECK_FALSE(held.target_reached);
  CHECK_THAT(held.why, Catch::Matchers::Contains("3072 vertices on open edges") &&
                           Catch::Matchers::Contains("join_doubled"));
}

TEST_CASE("join_doubled refuses what is no mesh, and values that do not fit") {
  IndexedMesh mesh = two_triangles();
  CHECK_THROWS_AS(join_doubled(mesh, {1, 2, 3}, 2), InvalidParameter);
  CHECK_THROWS_AS(join_doubled(mesh, {1, 2, 3}), InvalidParameter);
  mesh.triangles[1][2] = 6;
  CHECK_THROWS_AS(join_doubled(mesh), InvalidMesh);
}

TEST_CASE("join_doubled: an OpenMesh mesh keeps its order and all properties, and seams are at half-edges") {
  const IndexedMesh whole = shaken_torus();
  const CutMesh parts = cut_along(whole, meshes::grown_charts(whole, 100, 2));
  Mesh mesh = fixture::to_openmesh<Mesh>(parts.mesh);
  mesh.request_vertex_texcoords2D();
  OpenMesh::VPropHandleT<int> of_vertex;
  OpenMesh::FPropHandleT<int> of_face;
  OpenMesh::HPropHandleT<std::array<int, 3>> of_halfedge;  // its face and its ends
  OpenMesh::EPropHandleT<int> of_edge;
  mesh.add_property(of_vertex);
  mesh.add_property(of_face);
  mesh.add_property(of_halfedge);
  mesh.add_property(of_edge);
  for (const auto v : mesh.vertices()) {
    mesh.property(of_vertex, v) = v.idx();
    mesh.set_texcoord2D(v, {parts.chart[static_cast<std::size_t>(v.idx())], 0.5f});
  }
  for (const auto f : mesh.faces()) mesh.property(of_face, f) = f.idx();
  for (const auto h : mesh.halfedges())
    mesh.property(of_halfedge, h) = {h.face().idx(), h.from().idx(), h.to().idx()};
  for (const auto e : mesh.edges()) mesh.property(of_edge, e) = e.idx();
  const Mesh before = mesh;

  const auto joined = join_doubled(parts.mesh, parts.chart, 1);
  CHECK(join_doubled(mesh) == joined.joined);
  CHECK(to_indexed(mesh).triangles.size() == whole.triangles.size());
  CHECK(meshes::canonical(to_indexed(mesh)) ==
        meshes::canonical(to_indexed(fixture::to_openmesh<Mesh>(whole))));
  CHECK_FALSE(mesh.has_vertex_status());
  REQUIRE(mesh.has_halfedge_texcoords2D());
  CHECK_FALSE(mesh.has_halfedge_texcoords1D());
  int last = -1;
  for (const auto v : mesh.vertices()) {
    CHECK(mesh.property(of_vertex, v) > last);  // the first of those that it was
    last = mesh.property(of_vertex, v);
    CHECK(joined.vertex_map[static_cast<std::size_t>(last)] == static_cast<std::uint32_t>(v.idx()));
  }
  for (const auto h : mesh.halfedges()) {
    const auto [face, from, to] = mesh.property(of_halfedge, h);
    CHECK(face == h.face().idx());
    const auto became = [&](int v) {
      return static_cast<int>(joined.vertex_map[static_cast<std::size_t>(v)]);
    };
    CHECK(became(from) == h.from().idx());
    CHECK(became(to) == h.to().idx());
    CHECK(mesh.texcoord2D(h) == before.texcoord2D(Mesh::VertexHandle(to)));
    const auto e = before.edge_handle(before.find_halfedge(Mesh::VertexHandle(from), Mesh::VertexHandle(to)));
    const bool is_first = h.edge().h0() == h;
    if (is_first) CHECK(mesh.property(of_edge, h.edge()) == before.property(of_edge, e));
  }
  for (const auto f : mesh.faces()) CHECK(mesh.property(of_face, f) == f.idx());
  CHECK(join_doubled(mesh) == 0);

  DecimateOptions options;
  options.ratio = 0.3;
  const DecimateReport report = decimate(mesh, options);
  CHECK(report.target_reached);
  CHECK(report.charts == charts(joined.mesh.triangles, joined.wedges).count);
  CHECK(open_edges(mesh) == 0);
}

TEST_CASE("join_doubled: what an OpenMesh mesh has at half-edges already stays, and deleted elements go") {
  Mesh mesh = fixture::to_openmesh<Mesh>(two_triangles());
  mesh.request_vertex_texcoords1D();
  mesh.request_halfedge_texcoords1D();
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  for (const auto v : mesh.vertices()) mesh.set_texcoord1D(v, static_cast<float>(v.idx()));
  for (const auto h : mesh.halfedges())
    mesh.set_texcoord1D(h, static_cast<float>(10 * h.face().idx() + h.to().idx()));
  const auto lone =
      mesh.add_face(mesh.add_vertex({5, 5, 5}), mesh.add_vertex({6, 5, 5}), mesh.add_vertex({5, 6, 5}));
  mesh.delete_face(lone, true);
  const auto isolated = mesh.add_vertex({9, 9, 9});
  mesh.status(isolated).set_locked(true);
  CHECK(join_doubled(mesh) == 2);
  CHECK(mesh.n_faces() == 2);
  REQUIRE(mesh.n_vertices() == 5);
  CHECK(mesh.n_edges() == 5);
  CHECK(mesh.status(Mesh::VertexHandle(4)).locked());
  std::vector<float> corners;
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) corners.push_back(mesh.texcoord1D(h));
  std::sort(corners.begin(), corners.end());
  CHECK(corners == std::vector<float>{0, 1, 2, 13, 14, 15});
}

TEST_CASE("join_doubled: an OpenMesh mesh that cannot take the result stays as it was") {
  // A wheel of six faces that is cut along a spoke, and one more face at the hub of one side.
  IndexedMesh wheel = meshes::cone(6, 0);
  REQUIRE(wheel.triangles.size() == 6);
  const auto hub = wheel.triangles[0][0];
  REQUIRE(std::all_of(wheel.triangles.begin(), wheel.triangles.end(),
                      [&](const IndexedMesh::Triangle& t) { return t[0] == hub; }));
  const auto n = static_cast<std::uint32_t>(wheel.points.size());
  wheel.points.push_back(wheel.points[hub]);
  wheel.points.push_back(wheel.points[wheel.triangles[5][1]]);
  wheel.points.push_back(wheel.points[wheel.triangles[5][2]]);
  wheel.triangles[5] = {n, n + 1, n + 2};
  wheel.points.emplace_back(0.1, 0, 5);
  wheel.points.emplace_back(0, 0.1, 5);
  wheel.triangles.push_back({hub, n + 3, n + 4});
  Mesh mesh = fixture::to_openmesh<Mesh>(wheel);
  mesh.request_vertex_texcoords2D();
  for (const auto v : mesh.vertices()) mesh.set_texcoord2D(v, {static_cast<float>(v.idx()), 0});
  CHECK_THROWS_AS(join_doubled(mesh), InvalidMesh);
  CHECK(to_indexed(mesh).points == to_indexed(fixture::to_openmesh<Mesh>(wheel)).points);
  CHECK(to_indexed(mesh).triangles == wheel.triangles);
  CHECK(mesh.n_edges() == fixture::to_openmesh<Mesh>(wheel).n_edges());
  CHECK_FALSE(mesh.has_halfedge_texcoords2D());
}
