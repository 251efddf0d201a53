#include "whittle/SweepDecimaterT.hh"

#include "OpenMeshFixture.hh"
#include "connectivity.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/bulk.hh"

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
  CHECK_THROWS_AS(decimater.initialize(), NotReady);
  decimater.add(quadric);
  CHECK_THROWS_WITH(decimater.initialize(), Catch::Contains("LazyDecimaterT"));
  CHECK_THROWS_AS(decimater.decimate(), NotReady);
  decimater.remove(quadric);
  ModFaceAngleT<Mesh>::Handle fad;
  decimater.add(fad);
  CHECK_THROWS_AS(decimater.decimate(), NotReady);
  CHECK(decimater.initialize());
  decimater.remove(fad);
  CHECK_THROWS_AS(decimater.initialize(), NotReady);
}

TEST_CASE(
    "a decimater without its threshold, target or one module that decides the order says what is missing") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(8, 6));
  SECTION("no threshold") {
    SweepDecimaterT<Mesh> decimater(mesh);
    ModVertexDistanceT<Mesh>::Handle ivdd;
    decimater.add(ivdd);
    CHECK_THROWS_WITH(decimater.initialize(), Catch::Contains("max_distance is not set"));
    CHECK_FALSE(decimater.is_initialized());
    decimater.module(ivdd).set_max_distance(0.3);
    CHECK(decimater.initialize());
    CHECK(decimater.decimate() > 0);
  }
  SECTION("no target for mq") {
    SweepDecimaterT<Mesh> decimater(mesh);
    ModMemorylessQuadricT<Mesh>::Handle mq;
    decimater.add(mq);
    REQUIRE(decimater.initialize());
    CHECK_THROWS_WITH(decimater.decimate(), Catch::Contains("where to stop"));
    CHECK(decimater.decimate_to_faces(0, 50) > 0);
    CHECK(decimater.report().target_reached);
    CHECK(decimater.report().faces == 50);
  }
  SECTION("two modules that decide the order") {
    LazyDecimaterT<Mesh> decimater(mesh);
    CHECK_THROWS_AS(decimater.initialize(), NotReady);
    ModFaceAngleT<Mesh>::Handle fad;
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    decimater.add(fad);
    decimater.add(quadric);
    CHECK_THROWS_AS(decimater.initialize(), NotReady);
    decimater.module(fad).set_binary(true);
    CHECK(decimater.initialize());
  }
}

TEST_CASE(
    "the sweep gives the same half-edges whether it tests legality or the plan is alone on a fresh mesh") {
  std::vector<IndexedMesh> all{meshes::octahedron(), meshes::torus(24, 14), meshes::flat_grid(12),
                               meshes::strip(9, 1)};
  for (unsigned seed = 1; seed <= 4; ++seed) {
    all.push_back(meshes::shaken(meshes::torus(24, 14), 0.03, seed));
    all.push_back(meshes::riddled(meshes::shaken(meshes::flat_grid(16), 0.1, seed), 15, seed));
  }
  for (const IndexedMesh& in : all)
    for (const std::size_t target : {std::size_t{0}, in.triangles.size() / 2, in.triangles.size() / 10}) {
      Mesh proved = fixture::to_openmesh<Mesh>(in);
      if (target > 0) {  // without, the module is told of the collapses when all are done
        proved.request_face_normals();
        proved.request_vertex_normals();
        proved.update_normals();
      }
      proved.request_vertex_status();
      proved.request_edge_status();
      proved.request_face_status();
      Mesh tested = proved;
      const auto run = [&](Mesh& mesh, OpenMesh::Decimater::Observer* observer) {
        SweepDecimaterT<Mesh> decimater(mesh);
        ModMemorylessQuadricT<Mesh>::Handle mq;
        decimater.add(mq);
        decimater.module(mq).set_target_faces(std::max<std::size_t>(1, target));
        decimater.set_observer(observer);
        decimater.initialize();
        return decimater.decimate_to_faces(0, target);
      };
      fixture::StopAfter never(~std::size_t{0});
      const std::size_t collapses = run(proved, nullptr);
      REQUIRE(run(tested, &never) == collapses);
      REQUIRE((in.triangles.size() < 20 || collapses > 0));
      fixture::require_same_connectivity(proved, tested);
      for (const auto v : tested.vertices()) {
        REQUIRE(proved.point(v) == tested.point(v));
        if (tested.has_vertex_normals()) REQUIRE(proved.normal(v) == tested.normal(v));
      }
      if (tested.has_face_normals())
        for (const auto f : tested.faces()) REQUIRE(proved.normal(f) == tested.normal(f));
    }
}

TEST_CASE("the sweep tests legality again where the mesh has changed since it was planned on") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.01, 5));
  mesh.request_vertex_status();
  SweepDecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(0.2);
  REQUIRE(decimater.initialize());
  const auto& plan = decimater.module(ivdd).plan();
  const Mesh::VertexHandle first(static_cast<int>(plan.collapses.front().from));
  SECTION("a lock") {
    mesh.status(first).set_locked(true);
    decimater.decimate();
    CHECK_FALSE(mesh.status(first).deleted());
  }
  SECTION("locks of survivors, which do not move") {
    const Mesh before = mesh;
    for (const auto v : mesh.vertices()) mesh.status(v).set_locked(v.idx() % 3 == 0);
    CHECK(decimater.decimate() > 0);
    for (const auto v : before.vertices())
      if (v.idx() % 3 == 0) {
        CHECK_FALSE(mesh.status(v).deleted());
        CHECK(mesh.point(v) == before.point(v));
      }
  }
  SECTION("flipped edges") {
    std::size_t flipped = 0;
    for (const auto e : mesh.edges())
      if (flipped < 40 && mesh.is_flip_ok(e)) mesh.flip(e), ++flipped;
    const std::size_t collapses = decimater.decimate();
    CHECK(collapses < plan.collapses.size());
    mesh.garbage_collection();
    std::size_t corners = 0;
    for (const auto f : mesh.faces())
      for (const auto v : f.vertices()) corners += v.is_valid();
    CHECK(corners == 3 * mesh.n_faces());
    CHECK(mesh.n_vertices() == 336 - collapses);
    CHECK(mesh.n_faces() == 672 - 2 * collapses);
  }
}

TEST_CASE("a driver reports why it has missed its target") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.01, 5));  // 336 vertices
  mesh.request_vertex_status();
  mesh.request_face_normals();
  mesh.update_face_normals();
  for (int v = 0; v < 40; ++v) mesh.status(Mesh::VertexHandle(v)).set_locked(true);
  SweepDecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(0.2);
  SECTION("locks and the threshold") {
    REQUIRE(decimater.initialize());
    decimater.decimate_to_faces(0, 2);
    const RunReport& report = decimater.report();
    CHECK_FALSE(report.target_reached);
    CHECK(report.held == 40);
    CHECK(report.refused == 0);
    CHECK(report.vertices == 336 - report.collapses);
    CHECK(report.faces == 672 - 2 * report.collapses);
    CHECK(report.held + report.illegal + report.forbidden == report.vertices);
    CHECK(report.why().find("40 vertices are locked") == 0);
    CHECK(report.why().find("set_passes") != std::string::npos);
  }
  SECTION("a constraint") {
    OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
    decimater.add(flipping);
    decimater.module(flipping).set_max_normal_deviation(15);
    REQUIRE(decimater.initialize());
    decimater.decimate_to_faces(0, 2);
    CHECK(decimater.report().refused > 0);
    CHECK(decimater.report().why().find("refused by other modules") != std::string::npos);
  }
  SECTION("an observer") {
    fixture::StopAfter stop(3);
    decimater.set_observer(&stop);
    REQUIRE(decimater.initialize());
    decimater.decimate_to_faces(0, 2);
    CHECK(decimater.report().halted);
    CHECK(decimater.report().why() == "the observer called a halt");
  }
  SECTION("the module's own target") {
    SweepDecimaterT<Mesh> by_module(mesh);
    ModMemorylessQuadricT<Mesh>::Handle mq;
    by_module.add(mq);
    by_module.module(mq).set_target_faces(300);
    by_module.module(mq).set_max_distance(0);
    REQUIRE(by_module.initialize());
    by_module.decimate();
    CHECK_FALSE(by_module.report().target_reached);
    CHECK(by_module.report().held == 40);
    CHECK(by_module.report().record.refused_by_bound > 0);
    by_module.module(mq).set_max_distance(HUGE_VAL);
    by_module.decimate();
    CHECK(by_module.report().target_reached);
    CHECK(by_module.report().faces == 300);
  }
  SECTION("a target that is reached, or none") {
    REQUIRE(decimater.initialize());
    decimater.decimate_to_faces(0, 660);
    CHECK(decimater.report().target_reached);
    CHECK(decimater.report().faces == 660);
    CHECK(decimater.report().why().empty());
    decimater.decimate();
    CHECK(decimater.report().target_reached);
    CHECK(decimater.report().held == 0);
  }
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

TEST_CASE("mq through the sweep is mq by bulk, on any number of threads") {
  const Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(180, 90), 0.001, 5));
  MemorylessQuadric planner;
  planner.target_faces = mesh.n_faces() / 5;
  const auto expected = bulk(planner, to_indexed(mesh)).mesh;
  for (const std::size_t threads : {1u, 3u}) {
    const auto swept = fixture::run<SweepDecimaterT, ModMemorylessQuadricT>(mesh, [&](auto& mq) {
      mq.set_target_faces(planner.target_faces);
      mq.set_threads(threads);
    });
    CHECK(meshes::canonical(swept) == meshes::canonical(expected));
  }
}
