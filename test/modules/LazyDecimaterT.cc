#include "whittle/LazyDecimaterT.hh"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <vector>

#include "OpenMeshFixture.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/SweepDecimaterT.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

/// Half of the faces by ModQuadricT, with or without ModNormalFlippingT.
template <typename Decimater>
IndexedMesh halved(const IndexedMesh& in, bool guarded) {
  Mesh mesh = fixture::to_openmesh<Mesh>(in);
  mesh.request_face_status();
  mesh.request_face_normals();
  mesh.update_face_normals();
  Decimater decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(quadric);
  if (guarded) decimater.add(flipping);
  REQUIRE(decimater.initialize());
  decimater.decimate_to_faces(0, in.triangles.size() / 2);
  IndexedMesh out;
  const auto left = to_indexed(mesh);
  for (const auto& p : left.points) out.points.push_back(p.cast<double>());
  out.triangles = left.triangles;
  return out;
}

/// Prefers to remove vertex 0, into the rim's vertices in an order of its own, but not into the first two.
template <typename MeshT>
class NotFirstTwoT : public OpenMesh::Decimater::ModBaseT<MeshT>, public EarlyPriorityT<MeshT> {
 public:
  DECIMATING_MODULE(NotFirstTwoT, MeshT, NotFirstTwo);
  explicit NotFirstTwoT(MeshT& mesh) : Base(mesh, false) {}

  static int place_of(int rim_vertex) { return rim_vertex * 37 % 101; }  // 1..100 for 1..100
  bool decides_order() const override { return !Base::is_binary(); }
  float early_priority(const CollapseInfo& ci) override {
    REQUIRE(decides_order());
    return ci.v0.idx() == 0 ? static_cast<float>(place_of(ci.v1.idx())) : 1000;
  }
  float collapse_priority(const CollapseInfo& ci) override {
    if (Base::is_binary()) return 0;
    if (ci.v0.idx() != 0) return 1000;
    tested.push_back(place_of(ci.v1.idx()));
    return tested.back() >= 3 ? early_priority(ci) : -1;
  }
  std::vector<int> tested;
};

/// Which places are tested, in order, while a lazy decimater looks for one collapse and executes it.
std::vector<int> tested_in_one_collapse(Mesh& mesh) {
  LazyDecimaterT<Mesh> decimater(mesh);
  NotFirstTwoT<Mesh>::Handle chosen;
  decimater.add(chosen);
  REQUIRE(decimater.initialize());
  REQUIRE(decimater.decimate(1) == 1);
  return decimater.module(chosen).tested;
}

}  // namespace

TEST_CASE("the lazy decimater with ModQuadricT is as true as DecimaterT") {
  for (const bool guarded : {false, true}) {
    const IndexedMesh mesh = meshes::shaken(meshes::torus(96, 48), 0.002, 4);
    const IndexedMesh stock = halved<OpenMesh::Decimater::DecimaterT<Mesh>>(mesh, guarded);
    const IndexedMesh lazy = halved<LazyDecimaterT<Mesh>>(mesh, guarded);
    CHECK(lazy.triangles.size() == stock.triangles.size());
    CHECK(measure::facts(lazy).nonmanifold_edges == 0);
    CHECK(measure::facts(lazy).euler_characteristic == 0);
    CHECK(measure::distance(mesh, lazy).two_sided.mean <
          1.03 * measure::distance(mesh, stock).two_sided.mean);
  }
}

TEST_CASE("the lazy decimater repeats bit for bit, also where priorities are equal") {
  const IndexedMesh grid = meshes::flat_grid(20);
  const IndexedMesh a = halved<LazyDecimaterT<Mesh>>(grid, false),
                    b = halved<LazyDecimaterT<Mesh>>(grid, false);
  CHECK(a.triangles == b.triangles);
}

TEST_CASE("the lazy decimater executes a plan as the sweep does") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.03, seed));
    const auto fad = [](auto& module) { module.set_max_normal_angle(60); };
    const auto ivdd = [](auto& module) { module.set_max_distance(0.2); };
    using fixture::run;
    CHECK(run<LazyDecimaterT, ModFaceAngleT>(mesh, fad).triangles ==
          run<OpenMesh::Decimater::DecimaterT, ModFaceAngleT>(mesh, fad).triangles);
    CHECK(run<LazyDecimaterT, ModVertexDistanceT>(mesh, ivdd).points ==
          run<OpenMesh::Decimater::DecimaterT, ModVertexDistanceT>(mesh, ivdd).points);
  }
}

TEST_CASE("the lazy decimater takes the vertex with the least index where priorities are equal") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::flat_grid(6));
  LazyDecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  REQUIRE(decimater.initialize());
  REQUIRE(decimater.decimate(1) == 1);
  int gone = 0;
  while (!mesh.status(Mesh::VertexHandle(gone)).deleted()) ++gone;
  CHECK(gone <= 1);  // a corner of one face stays
}

TEST_CASE("the lazy decimater reaches its target, and executes a plan, around vertices of very many faces") {
  meshes::IndexedMesh bipyramid = meshes::cone(300, 0.5);
  bipyramid.points.emplace_back(0, 0, -0.5);
  for (std::uint32_t i = 0; i < 300; ++i) bipyramid.triangles.push_back({301, (i + 1) % 300 + 1, i + 1});
  const auto facts = measure::facts(halved<LazyDecimaterT<Mesh>>(bipyramid, true));
  CHECK(facts.faces == 300);
  CHECK(facts.boundary_edges == 0);
  const Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(bipyramid, 0.001, 1));
  const auto ivdd = [](auto& module) { module.set_max_distance(0.6); };
  using fixture::run;
  const auto lazy = run<LazyDecimaterT, ModVertexDistanceT>(mesh, ivdd);
  CHECK(lazy.points == run<SweepDecimaterT, ModVertexDistanceT>(mesh, ivdd).points);
  CHECK(lazy.triangles.size() < 500);
}

TEST_CASE(
    "the lazy decimater tests a hub's collapses in the order of their early priorities, to the first that is "
    "allowed") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::cone(100, 0.5));
  mesh.request_vertex_status();  // it is looked at when the decimater has gone
  CHECK(tested_in_one_collapse(mesh) == std::vector<int>{1, 2, 3});
  CHECK(mesh.status(Mesh::VertexHandle(0)).deleted());
  for (int v = 1; v <= 100; ++v)
    CHECK((mesh.valence(Mesh::VertexHandle(v)) > 3) == (NotFirstTwoT<Mesh>::place_of(v) == 3));
}

TEST_CASE("the lazy decimater tests none of a vertex's collapses that cannot be the best") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::cone(20, 0.5));
  const std::vector<int> tested = tested_in_one_collapse(mesh);
  for (std::size_t i = 1; i < tested.size(); ++i) CHECK(tested[i] < tested[i - 1]);
  CHECK(tested.back() == 3);
  CHECK(tested.size() < 20);
}

TEST_CASE("the lazy decimater asks for early priorities of the module only that decides the order") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::cone(100, 0.5));
  LazyDecimaterT<Mesh> decimater(mesh);
  NotFirstTwoT<Mesh>::Handle binary, removed;
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(removed);
  decimater.add(binary);
  decimater.add(quadric);
  decimater.remove(removed);
  decimater.module(binary).set_binary(true);
  REQUIRE(decimater.initialize());
  CHECK(decimater.decimate(1) == 1);
}

TEST_CASE("the lazy decimater honours targets, selection and observers") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(24, 14));
  LazyDecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  CHECK_THROWS_AS(decimater.initialize(), NotReady);
  CHECK_THROWS_AS(decimater.decimate(), NotReady);
  decimater.add(quadric);
  REQUIRE(decimater.initialize());
  CHECK(decimater.decimate(0, true) == 0);
  CHECK(decimater.decimate(7) == 7);
  CHECK(decimater.decimate_to(325) == 4);
  CHECK(decimater.decimate_to_faces(0, 640) == 5);
  fixture::StopAfter stop(3);
  decimater.set_observer(&stop);
  CHECK(decimater.decimate() == 3);
}

TEST_CASE("the drivers take meshes that could have polygons, too") {
  using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.03, 2);
  const auto fad = [](auto& module) { module.set_max_normal_angle(60); };
  const auto tri = fixture::run<SweepDecimaterT, ModFaceAngleT>(fixture::to_openmesh<Mesh>(mesh), fad);
  const auto swept = fixture::run<SweepDecimaterT, ModFaceAngleT>(fixture::to_openmesh<PolyMesh>(mesh), fad);
  const auto lazy = fixture::run<LazyDecimaterT, ModFaceAngleT>(fixture::to_openmesh<PolyMesh>(mesh), fad);
  CHECK(tri.triangles.size() < mesh.triangles.size());
  CHECK(meshes::canonical(swept) == meshes::canonical(tri));
  CHECK(meshes::canonical(lazy) == meshes::canonical(tri));
}
