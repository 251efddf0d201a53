#include <algorithm>
#include <cmath>

#include "OpenMeshFixture.hh"
#include "measure/MeshFacts.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModGuardedQuadricT.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

using Guarded = ModGuardedQuadricT<Mesh>;

/// A decimation down to so many faces by one priority module.
template <typename Module, typename Decimater = LazyDecimaterT<Mesh>, typename Setup>
IndexedMesh to_faces(const IndexedMesh& in, std::size_t faces, Setup setup) {
  Mesh mesh = fixture::to_openmesh<Mesh>(in);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  Decimater decimater(mesh);
  typename Module::Handle handle;
  decimater.add(handle);
  setup(mesh, decimater.module(handle));
  REQUIRE(decimater.initialize());
  decimater.decimate_to_faces(0, faces);
  const auto left = to_indexed(mesh);
  IndexedMesh out;
  for (const auto& p : left.points) out.points.push_back(p.cast<double>());
  out.triangles = left.triangles;
  return out;
}

const auto as_it_is = [](Mesh&, auto&) {};

double area_upwards(const IndexedMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).z() / 2;
  return area;
}

}  // namespace

TEST_CASE("without guards the guarded quadric is ModQuadricT") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  const auto stock = to_faces<OpenMesh::Decimater::ModQuadricT<Mesh>>(mesh, 500, as_it_is);
  const auto ours = to_faces<Guarded>(mesh, 500, [](Mesh&, Guarded& module) {
    module.set_boundary_weight(0);
    module.set_flip_guard(-1);
  });
  CHECK(ours.points == stock.points);
  CHECK(ours.triangles == stock.triangles);
}

TEST_CASE("a flat grid keeps its area, and no face flips, where ModQuadricT eats it") {
  const IndexedMesh grid = meshes::flat_grid(60);
  const double whole = area_upwards(grid);
  const auto stock = to_faces<OpenMesh::Decimater::ModQuadricT<Mesh>, OpenMesh::Decimater::DecimaterT<Mesh>>(
      grid, 200, as_it_is);
  CHECK(measure::facts(stock).area < 0.9 * whole);

  const auto ours = to_faces<Guarded>(grid, 200, as_it_is);
  CHECK(ours.triangles.size() <= 200);
  CHECK(area_upwards(ours) == Approx(whole).epsilon(1e-6));
  CHECK(measure::facts(ours).area == Approx(whole).epsilon(1e-6));  // nothing folded back
}

TEST_CASE("the guard of the guarded quadric judges by the mesh at the beginning") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.02, 3);
  Mesh om = fixture::to_openmesh<Mesh>(mesh);
  om.request_vertex_status();
  om.request_edge_status();
  om.request_face_status();
  om.request_face_normals();
  om.update_face_normals();
  std::vector<Mesh::Normal> before;
  for (const auto f : om.faces()) before.push_back(om.normal(f));
  LazyDecimaterT<Mesh> decimater(om);
  Guarded::Handle handle;
  decimater.add(handle);
  decimater.module(handle).set_flip_guard(0.5);
  REQUIRE(decimater.initialize());
  CHECK(decimater.decimate_to_faces(0, 400) > 0);
  float least = 1;
  for (const auto f : om.all_faces())
    if (!om.status(f).deleted())
      least = std::min(least, om.calc_face_normal(f) | before[static_cast<std::size_t>(f.idx())]);
  CHECK(least > 0.4999f);
}

TEST_CASE("the guarded quadric leaves no face without area, be it of the right side") {
  IndexedMesh fan;
  for (const auto& [x, y] : std::initializer_list<std::pair<double, double>>{
           {1.2, 0.8}, {0, 0}, {1, 0}, {2, 1e-13}, {2, 2}, {0, 2}})
    fan.points.emplace_back(x, y, 0);
  for (std::uint32_t i = 1; i <= 5; ++i) fan.triangles.push_back({0, i, i % 5 + 1});
  Mesh mesh = fixture::to_openmesh<Mesh>(fan);
  Guarded module(mesh);
  module.initialize();
  const auto is_legal = [&](int onto) {
    const auto h = mesh.find_halfedge(Mesh::VertexHandle(0), Mesh::VertexHandle(onto));
    return module.collapse_priority(OpenMesh::Decimater::CollapseInfoT<Mesh>(mesh, h)) !=
           float(Guarded::ILLEGAL_COLLAPSE);
  };
  CHECK_FALSE(is_legal(1));  // 1, 2 and 3 all but lie on a line
  CHECK(is_legal(4));
}

TEST_CASE("weights keep detail where they are high") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  const auto left_of_zero = [](const IndexedMesh& m) {
    return double(std::count_if(m.triangles.begin(), m.triangles.end(),
                                [&](const auto& t) { return m.points[t[0]].x() < 0; }));
  };
  const auto plain = to_faces<Guarded>(mesh, 600, as_it_is);
  const auto weighted = to_faces<Guarded>(mesh, 600, [](Mesh& om, Guarded& module) {
    OpenMesh::VPropHandleT<float> weight;
    om.add_property(weight);
    for (const auto v : om.vertices()) om.property(weight, v) = om.point(v)[0] < 0 ? 100.0f : 1.0f;
    module.set_weight(weight);
  });
  CHECK(left_of_zero(weighted) > 1.3 * left_of_zero(plain));
}

TEST_CASE("the guarded quadric refuses what means nothing") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::octahedron());
  Guarded module(mesh);
  CHECK_THROWS_AS(module.set_max_err(0), InvalidParameter);
  CHECK_THROWS_AS(module.set_boundary_weight(-1), InvalidParameter);
  CHECK_THROWS_AS(module.set_flip_guard(1), InvalidParameter);
  OpenMesh::VPropHandleT<float> weight;
  mesh.add_property(weight);
  for (const auto v : mesh.vertices()) mesh.property(weight, v) = -1;
  module.set_weight(weight);
  CHECK_THROWS_AS(module.initialize(), InvalidParameter);
}

namespace {

/// A module of its own, and what it says of a collapse.
struct Judge {
  explicit Judge(const IndexedMesh& in, double min_cos = -1)
      : mesh(fixture::to_openmesh<Mesh>(in)), module(mesh) {
    module.set_flip_guard(min_cos);
    module.initialize();
  }
  OpenMesh::Decimater::CollapseInfoT<Mesh> collapse(int from, int onto) {
    return {mesh, mesh.find_halfedge(Mesh::VertexHandle(from), Mesh::VertexHandle(onto))};
  }
  float error(int from, int onto) { return module.collapse_priority(collapse(from, onto)); }
  Mesh mesh;
  Guarded module;
};

constexpr float kIllegal = float(Guarded::ILLEGAL_COLLAPSE);

}  // namespace

TEST_CASE("the guarded quadric weighs faces by area and the boundary by ten times its length squared") {
  // Faces 0 3 4 and 0 5 3 of an octahedron do not have 1; their area is sqrt(3) / 2, their planes 2 / sqrt(3) from it.
  Judge closed(meshes::octahedron());
  CHECK(closed.error(0, 1) == Approx(4 / std::sqrt(3.0)).epsilon(1e-6));
  // A survivor has the planes of both: those of 0 are as far from 4 as from 1.
  const float before = closed.error(1, 4);
  closed.module.postprocess_collapse(closed.collapse(0, 1));
  CHECK(closed.error(1, 4) - before == Approx(4 / std::sqrt(3.0)).epsilon(1e-6));

  // A strip of squares of side 2: from the middle of one side to that of the other, past two edges.
  IndexedMesh strip = meshes::strip(3, 1);
  for (auto& p : strip.points) p *= 2;
  Judge open(strip);
  CHECK(open.error(1, 4) == Approx(2 * 10 * 4 * 4));
  open.module.set_boundary_weight(3);
  open.module.initialize();
  CHECK(open.error(1, 4) == Approx(2 * 3 * 4 * 4));
}

TEST_CASE("the guarded quadric's largest error is just not allowed, and scales from where it was set") {
  IndexedMesh strip = meshes::strip(3, 1);
  for (auto& p : strip.points) p *= 2;
  Judge judge(strip);
  judge.module.set_max_err(320, false);
  CHECK(judge.error(1, 4) == kIllegal);
  judge.module.set_max_err(321, true);
  CHECK(judge.error(1, 4) != kIllegal);
  judge.module.set_error_tolerance_factor(0.5);
  CHECK(judge.module.max_err() == 160.5);
  judge.module.set_error_tolerance_factor(1);
  CHECK(judge.module.max_err() == 321);
}

TEST_CASE("the guarded quadric leaves a face that has an area, however thin") {
  for (const auto& [height, is_legal] : {std::pair(1e-11, false), std::pair(1e-10, true)}) {
    IndexedMesh fan;
    fan.points = {{1.2, 0.8, 0}, {0, 0, 0}, {1, 0, 0}, {2, height, 0}, {2, 2, 0}, {0, 2, 0}};
    for (std::uint32_t i = 1; i <= 5; ++i) fan.triangles.push_back({0, i, i % 5 + 1});
    CHECK((Judge(fan, 0.2).error(0, 1) != kIllegal) == is_legal);  // leaves 1 2 3
  }
}

TEST_CASE("the guarded quadric decimates alike at any size that coordinates can have") {
  using Doubles = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
  const IndexedMesh torus = meshes::shaken(meshes::torus(16, 12), 0.01, 1);
  const auto left_at = [&](int exponent) {
    IndexedMesh in = torus;
    for (auto& p : in.points) p = p.unaryExpr([&](double x) { return std::ldexp(x, exponent); });
    auto mesh = fixture::to_openmesh<Doubles>(in);
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_face_status();
    LazyDecimaterT<Doubles> decimater(mesh);
    ModGuardedQuadricT<Doubles>::Handle handle;
    decimater.add(handle);
    decimater.initialize();
    decimater.decimate_to_faces(0, 100);
    return to_indexed(mesh).triangles;
  };
  const auto expected = left_at(0);
  CHECK(expected.size() <= 100);
  for (const int exponent : {-960, -300, -40, -10, 10, 40, 300, 1020}) CHECK((left_at(exponent) == expected));

  Mesh broken = fixture::to_openmesh<Mesh>(meshes::octahedron());
  broken.set_point(Mesh::VertexHandle(2), {0, INFINITY, 0});
  Guarded module(broken);
  CHECK_THROWS_AS(module.initialize(), InvalidMesh);
}

TEST_CASE(
    "the guarded quadric refuses the same at a vertex of very many faces, whichever edge is asked first") {
  for (const int n : {40, 70, 130}) {
    IndexedMesh cone = meshes::cone(n, 3);
    for (std::size_t i = 1; i < cone.points.size(); ++i)
      if (i % 7 == 0) cone.points[i] *= 0.5;  // dents in the rim
    Judge judge(cone, 0.2);
    std::vector<bool> forth, back;
    for (int i = 1; i <= n; ++i) forth.push_back(judge.error(0, i) != kIllegal);
    for (int i = n; i >= 1; --i) back.push_back(Judge(cone, 0.2).error(0, i) != kIllegal);
    std::reverse(back.begin(), back.end());
    CHECK(forth == back);
  }
}

TEST_CASE("the guarded quadric carries half-edge texture coordinates over, and none tears") {
  const IndexedMesh grid = meshes::flat_grid(13);
  Mesh mesh = fixture::to_openmesh<Mesh>(grid);
  mesh.request_halfedge_texcoords2D();
  const auto chart_at = [](float x) { return x > 6 ? 1.0f : 0.0f; };
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to());
      mesh.set_texcoord2D(h, {p[0] + 100 * chart_at(mesh.calc_face_centroid(f)[0]), p[1]});
    }
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  LazyDecimaterT<Mesh> decimater(mesh);
  Guarded::Handle handle;
  decimater.add(handle);
  REQUIRE(decimater.initialize());
  decimater.decimate_to_faces(0, 30);
  CHECK(decimater.report().faces <= 30);
  std::size_t on_seam = 0;
  for (const auto v : mesh.vertices()) on_seam += mesh.point(v)[0] == 6;
  CHECK(on_seam < 13);
  CHECK(on_seam >= 2);
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to());
      const float expected = p[0] + 100 * chart_at(mesh.calc_face_centroid(f)[0]);
      CHECK(mesh.texcoord2D(h) == Mesh::TexCoord2D(expected, p[1]));  // no vertex moves, so to the bit
    }
}

TEST_CASE("the guarded quadric merges along seams only, and lets a chart vanish unless it is to stay") {
  const IndexedMesh in = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  for (const bool keep : {false, true}) {
    Mesh mesh = fixture::to_openmesh<Mesh>(in);
    mesh.request_halfedge_texcoords1D();
    for (const auto h : mesh.fh_range(Mesh::FaceHandle(0))) mesh.set_texcoord1D(h, 1);
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_face_status();
    mesh.request_halfedge_status();
    Guarded module(mesh);
    module.set_keep_charts(keep);
    module.set_flip_guard(-1);
    module.initialize();
    const auto is_allowed = [&](int from, int to) {
      const auto h = mesh.find_halfedge(Mesh::VertexHandle(from), Mesh::VertexHandle(to));
      return module.collapse_priority(OpenMesh::Decimater::CollapseInfoT<Mesh>(mesh, h)) >= 0;
    };
    for (int v = 0; v < 3; ++v) {
      CHECK(is_allowed(v, (v + 1) % 3) != keep);
      CHECK(is_allowed((v + 1) % 3, v) != keep);
    }
    CHECK_FALSE(is_allowed(0, 3));  // off the seam
    CHECK(is_allowed(3, 0));        // onto it
    if (keep) continue;
    const auto h = mesh.find_halfedge(Mesh::VertexHandle(0), Mesh::VertexHandle(1));
    OpenMesh::Decimater::CollapseInfoT<Mesh> info(mesh, h);
    module.preprocess_collapse(info);
    mesh.collapse(h);
    module.postprocess_collapse(info);
    for (const auto v : mesh.vertices()) CHECK_FALSE(detail::is_on_seam(mesh, v));
    for (const auto f : mesh.faces())
      for (const auto corner : mesh.fh_range(f)) CHECK(mesh.texcoord1D(corner) == 0);
  }
}
