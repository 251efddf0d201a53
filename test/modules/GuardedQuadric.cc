#include <algorithm>

#include "OpenMeshFixture.hh"
#include "measure/MeshFacts.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModGuardedQuadricT.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

using Guarded = ModGuardedQuadricT<Mesh>;

/// A decimation down to so many faces by one priority module.
template <typename Module, typename Setup>
IndexedMesh to_faces(const IndexedMesh& in, std::size_t faces, Setup setup) {
  Mesh mesh = fixture::to_openmesh<Mesh>(in);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  LazyDecimaterT<Mesh> decimater(mesh);
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
  const auto stock = to_faces<OpenMesh::Decimater::ModQuadricT<Mesh>>(grid, 200, as_it_is);
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
