#include "whittle/SweepDecimaterT.hh"

#include "OpenMeshFixture.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModVertexDistanceT.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

/// DecimaterT, SweepDecimaterT and the bulk executor on one mesh must give the same surface, and all of the
/// plan.
template <template <typename> class Module, typename Setup>
void check_agreement(const IndexedMesh& in, Setup setup) {
  const Mesh mesh = fixture::to_openmesh<Mesh>(in);
  std::size_t heap = 0, swept = 0;
  const auto by_heap = fixture::run<OpenMesh::Decimater::DecimaterT, Module>(mesh, setup, &heap);
  const auto by_sweep = fixture::run<SweepDecimaterT, Module>(mesh, setup, &swept);
  CHECK(by_heap.points == by_sweep.points);
  CHECK(by_heap.triangles == by_sweep.triangles);

  const auto flat = to_indexed(mesh);
  Mesh copy = mesh;
  Module<Mesh> module(copy);
  setup(module);
  const CollapsePlan plan = module.plan();
  CHECK(plan.collapses.size() == swept);
  CHECK(plan.collapses.size() == heap);
  CHECK(meshes::canonical(execute(plan, flat).mesh) == meshes::canonical(by_sweep));
}

}  // namespace

TEST_CASE("the executors agree on closed, open and riddled meshes") {
  std::vector<IndexedMesh> all{meshes::octahedron(), meshes::torus(24, 14), meshes::flat_grid(12)};
  for (unsigned seed = 1; seed <= 6; ++seed) {
    all.push_back(meshes::shaken(meshes::torus(24, 14), 0.03, seed));
    all.push_back(meshes::shaken(meshes::flat_grid(14), 0.4, seed));
    all.push_back(meshes::riddled(meshes::shaken(meshes::flat_grid(16), 0.1, seed), 15, seed));
  }
  for (const IndexedMesh& mesh : all) {
    for (const double angle : {10.0, 60.0, 180.0})
      check_agreement<ModFaceAngleT>(mesh, [&](auto& fad) { fad.set_max_normal_angle(angle); });
    for (const double distance : {0.1, 0.9, 1.3, 5.0})
      check_agreement<ModVertexDistanceT>(mesh, [&](auto& ivdd) { ivdd.set_max_distance(distance); });
  }
}

TEST_CASE("the sweep needs a module with a plan") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(8, 6));
  SweepDecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  CHECK_FALSE(decimater.initialize());
  decimater.add(quadric);
  CHECK_FALSE(decimater.initialize());
  CHECK(decimater.decimate() == 0);
  decimater.remove(quadric);
  ModFaceAngleT<Mesh>::Handle fad;
  decimater.add(fad);
  CHECK(decimater.initialize());
  decimater.remove(fad);
  CHECK_FALSE(decimater.initialize());
}

TEST_CASE("the sweep honours targets, selection, observers and constraints") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.01, 5));
  mesh.request_face_normals();
  mesh.update_face_normals();
  SweepDecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(0.2);
  const std::size_t planned = decimater.module(ivdd).plan().collapses.size();
  SECTION("a number of collapses") {
    REQUIRE(decimater.initialize());
    CHECK(decimater.decimate(7) == 7);
    CHECK(decimater.decimate() == planned - 7);
    CHECK(decimater.refused() == 0);
  }
  SECTION("targets count what is alive, also the second time") {
    REQUIRE(decimater.initialize());
    CHECK(decimater.decimate_to(330) == 6);
    CHECK(decimater.decimate_to_faces(0, 650) == 5);
    CHECK(decimater.decimate_to_faces(0, 650) == 0);
  }
  SECTION("selection") {
    REQUIRE(decimater.initialize());
    CHECK(decimater.decimate(0, true) == 0);
    for (int v = 0; v < 168; ++v) mesh.status(Mesh::VertexHandle(v)).set_selected(true);
    const std::size_t done = decimater.decimate(0, true);
    CHECK(done > 0);
    CHECK(done < planned);
  }
  SECTION("an observer that stops early") {
    fixture::StopAfter stop(3);
    decimater.set_observer(&stop);
    REQUIRE(decimater.initialize());
    CHECK(decimater.decimate() == 3);
  }
  SECTION("a constraint") {
    decimater.add(flipping);
    decimater.module(flipping).set_max_normal_deviation(15);
    REQUIRE(decimater.initialize());
    const std::size_t done = decimater.decimate();
    CHECK(done > 0);
    CHECK(done + decimater.refused() == planned);
    CHECK(decimater.refused() > 0);
  }
}
