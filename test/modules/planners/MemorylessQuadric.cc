#include "whittle/planners/MemorylessQuadric.hh"

#include <Eigen/Geometry>

#include "OpenMeshFixture.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/bulk.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

MemorylessQuadric down_to(std::size_t faces) {
  MemorylessQuadric planner;
  planner.target_faces = faces;
  return planner;
}

void check_topology(const IndexedMesh& before, const IndexedMesh& after) {
  const auto a = measure::facts(before), b = measure::facts(after);
  CHECK(b.nonmanifold_edges == a.nonmanifold_edges);
  CHECK(b.nonmanifold_vertices == a.nonmanifold_vertices);
  CHECK(b.euler_characteristic == a.euler_characteristic);
  CHECK(b.boundary_loops == a.boundary_loops);
  CHECK(b.components == a.components);
  CHECK(b.duplicate_faces == 0);
  CHECK(b.isolated_vertices == a.isolated_vertices);
}

std::size_t turned_over(const IndexedMesh& before, const ExecutedT<double>& after) {
  const SurfaceT<double> a(before), b(after.mesh);
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < b.n_faces(); ++f)
    count += !(b.normal(f).dot(a.normal(after.face_origin[f])) > 0);
  return count;
}

}  // namespace

TEST_CASE("mq reaches its target, keeps the topology and turns no face over") {
  for (const IndexedMesh& mesh : {meshes::torus(48, 24), meshes::shaken(meshes::torus(48, 24), 0.004, 1),
                                  meshes::grid(40, [](std::uint32_t i, std::uint32_t j) {
                                    return std::sin(i * 0.3) * std::cos(j * 0.2);
                                  })}) {
    for (const std::size_t target : {1500u, 600u, 120u}) {
      const auto out = bulk(down_to(target), mesh);
      CHECK(out.mesh.triangles.size() <= target);
      CHECK(out.mesh.triangles.size() + 2 > target);
      check_topology(mesh, out.mesh);
      CHECK(turned_over(mesh, out) == 0);
      CHECK(out.record.planned == out.collapses);
    }
  }
}

TEST_CASE("mq goes by vertices, too") {
  MemorylessQuadric planner;
  planner.target_vertices = 200;
  CHECK(bulk(planner, meshes::torus(48, 24)).mesh.points.size() == 200);
}

TEST_CASE("mq judges faces by the normals that it is given") {
  const IndexedMesh grid = meshes::flat_grid(8);
  for (const double up : {1e-30, -1e-30}) {  // any length will do
    SurfaceExtras extras;
    extras.reference_normals.assign(grid.triangles.size(), {0, 0, up});
    CHECK(down_to(20).plan(SurfaceT<double>(grid, extras)).collapses.empty() == (up < 0));
    // Of two neighbours' places the one that is looked down upon stays as it is.
    for (std::size_t f = 0; f < grid.triangles.size() / 2; ++f) extras.reference_normals[f] *= -1;
    const CollapsePlan half = down_to(0).plan(SurfaceT<double>(grid, extras));
    CHECK_FALSE(half.collapses.empty());
    const auto left = execute(half, grid);
    const bool first_half = up > 0;
    for (std::size_t f = 0; f < left.face_origin.size(); ++f) {
      if ((left.face_origin[f] < grid.triangles.size() / 2) != first_half) continue;
      const auto &now = left.mesh.triangles[f], &then = grid.triangles[left.face_origin[f]];
      for (int k = 0; k < 3; ++k) CHECK(left.mesh.points[now[k]] == grid.points[then[k]]);
    }
  }
}

TEST_CASE("mq keeps a flat square a flat square") {
  const IndexedMesh grid = meshes::flat_grid(30);  // 1682 faces over 29 x 29
  const auto out = bulk(down_to(60), grid);
  CHECK(out.mesh.triangles.size() <= 60);
  const auto facts = measure::facts(out.mesh), before = measure::facts(grid);
  CHECK(facts.area == Approx(before.area).epsilon(1e-3));
  CHECK(facts.boundary_loops == 1);
  for (const auto& p : out.mesh.points) CHECK(std::abs(p.z()) < 1e-5);
}

TEST_CASE("mq is much truer to the shape than ModQuadricT") {
  using Mesh = fixture::Mesh;
  const IndexedMesh mesh = meshes::shaken(meshes::torus(96, 48), 0.002, 4);
  Mesh stock = fixture::to_openmesh<Mesh>(mesh);
  stock.request_face_status();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(stock);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  REQUIRE(decimater.initialize());
  decimater.decimate_to_faces(0, 920);
  IndexedMesh theirs;
  const auto left = to_indexed(stock);
  for (const auto& p : left.points) theirs.points.push_back(p.cast<double>());
  theirs.triangles = left.triangles;
  const auto ours = bulk(down_to(theirs.triangles.size()), mesh).mesh;
  CHECK(measure::distance(mesh, ours).two_sided.rms < 0.8 * measure::distance(mesh, theirs).two_sided.rms);
}

TEST_CASE("mq plans the same on any number of threads, also where the mesh is cut into parts") {
  struct Case {
    IndexedMesh torus;
    std::size_t target;
    std::vector<std::size_t> threads;
  };
  for (const auto& [torus, target, threads] :
       {Case{meshes::torus(180, 100), 18000, {2, 7}}, Case{meshes::torus(210, 160), 12000, {3}}}) {
    const IndexedMesh mesh = meshes::riddled(meshes::shaken(torus, 0.0005, 1), 40, 3);
    REQUIRE(mesh.points.size() > 2 * 8192);
    BulkOptions options;
    options.threads = 1;
    const auto one = bulk(down_to(target), mesh, options);
    CHECK(one.mesh.triangles.size() <= target);
    CHECK(one.mesh.triangles.size() + 2 > target);
    check_topology(mesh, one.mesh);
    CHECK(turned_over(mesh, one) == 0);
    for (const std::size_t n_threads : threads) {
      options.threads = n_threads;
      const auto many = bulk(down_to(target), mesh, options);
      REQUIRE(many.mesh.triangles == one.mesh.triangles);
      REQUIRE(many.mesh.points == one.mesh.points);
    }
  }
}

TEST_CASE("every beginning of an mq plan is a valid, coarser mesh") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(20, 12), 0.01, 2);
  const CollapsePlan plan = down_to(0).plan(SurfaceT<double>(mesh));
  REQUIRE(plan.collapses.size() > 150);
  std::size_t faces = mesh.triangles.size();
  for (std::size_t n = 0; n < plan.collapses.size(); n += 7) {
    const auto part = execute(plan, mesh, n);
    CHECK(part.mesh.triangles.size() <= faces);
    faces = part.mesh.triangles.size();
    check_topology(mesh, part.mesh);
  }
}

TEST_CASE("mq leaves what is held where it is, to the bit") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.01, 3);
  BulkOptions options;
  options.extras.flags.assign(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); v += 5)
    options.extras.flags[v] = v % 2 ? kLocked : v % 3 ? kFeature : kSeam;
  const auto out = bulk(down_to(200), mesh, options);
  CHECK(out.mesh.triangles.size() < mesh.triangles.size());
  for (std::size_t v = 0; v < mesh.points.size(); v += 5) {
    CHECK(out.survives[v]);
    CHECK(out.mesh.points[out.vertex_map[v]] == mesh.points[v]);
  }
  check_topology(mesh, out.mesh);

  options.extras.flags.assign(mesh.points.size(), kLocked);
  CHECK(bulk(down_to(10), mesh, options).collapses == 0);
}

TEST_CASE("mq does what it can with holes, pinched vertices and small pieces") {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const IndexedMesh mesh = meshes::riddled(meshes::shaken(meshes::torus(24, 14), 0.01, seed), 6, seed);
    const auto out = bulk(down_to(1), mesh);
    CHECK(out.collapses > 50);
    const auto a = measure::facts(mesh), b = measure::facts(out.mesh);
    CHECK(b.nonmanifold_edges == 0);
    CHECK(b.nonmanifold_vertices == a.nonmanifold_vertices);
    CHECK(b.components == a.components);
    CHECK(b.euler_characteristic == a.euler_characteristic);
    CHECK(turned_over(mesh, out) == 0);
  }
  for (const IndexedMesh& mesh :
       {meshes::tetrahedron(), meshes::lone_triangle(), meshes::isolated_points(4), IndexedMesh()})
    CHECK(bulk(down_to(1), mesh).collapses == 0);
}

TEST_CASE("mq plans the same for a mesh that is larger or elsewhere by a power of two") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.01, 3);
  IndexedMesh large = mesh;
  for (auto& p : large.points) p *= 1 << 20;
  const auto a = bulk(down_to(150), mesh), b = bulk(down_to(150), large);
  CHECK(a.mesh.triangles == b.mesh.triangles);
  IndexedMesh small = mesh;
  for (auto& p : small.points) p *= std::ldexp(1.0, -60);
  CHECK(bulk(down_to(150), small).mesh.triangles == a.mesh.triangles);
}

TEST_CASE("the sweep executes an mq plan as bulk does, and finds all of it legal") {
  for (const IndexedMesh& mesh :
       {meshes::shaken(meshes::torus(24, 14), 0.01, 3),
        meshes::grid(24, [](std::uint32_t i, std::uint32_t j) { return 0.01 * i * j; })}) {
    using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
    Mesh swept = fixture::to_openmesh<Mesh>(mesh);
    swept.request_vertex_status();
    swept.request_edge_status();
    swept.request_face_status();
    SweepDecimaterT<Mesh> decimater(swept);
    ModMemorylessQuadricT<Mesh>::Handle handle;
    decimater.add(handle);
    decimater.module(handle).set_target_faces(200);
    REQUIRE(decimater.initialize());
    const std::size_t done = decimater.decimate();
    CHECK(decimater.refused() == 0);
    const auto out = bulk(down_to(200), mesh);
    CHECK(done == out.collapses);
    CHECK(meshes::canonical(to_indexed(swept)) == meshes::canonical(out.mesh));
  }
}

TEST_CASE("mq refuses a guard out of range") {
  MemorylessQuadric planner;
  planner.guard.min_cos = 1;
  CHECK_THROWS_AS(planner.validate(), InvalidParameter);
}

TEST_CASE("mq makes only finite coordinates, however small or large the mesh is") {
  for (const double scale : {5e-324, 1e-310, 4e-309, 1e-300, 1e-150, 1.0, 1e60, 1e99}) {
    INFO(scale);
    IndexedMesh mesh = meshes::torus(16, 10);
    for (auto& p : mesh.points) p *= scale;
    const auto out = bulk(down_to(160), mesh);
    for (const auto& p : out.mesh.points) REQUIRE(p.allFinite());
    if (scale > 1e-299) CHECK(out.mesh.triangles.size() == 160);
  }
}

TEST_CASE("mq leaves a held vertex at its coordinates, which floats would round") {
  IndexedMesh mesh = meshes::flat_grid(5);
  const Eigen::Vector3d odd(2 + 1e-9, 2 - 1e-9, 1e-9);
  mesh.points[12] = odd;
  SurfaceExtras extras;
  extras.flags.assign(25, 0);
  extras.flags[12] = kLocked;
  MemorylessQuadric planner;
  planner.target_faces = 12;
  bool is_target = false;
  for (const Collapse& collapse : planner.plan(SurfaceT<double>(mesh, extras)).collapses) {
    CHECK(collapse.from != 12);
    if (collapse.to != 12) continue;
    CHECK(collapse.target == odd);
    is_target = true;
  }
  CHECK(is_target);
}

TEST_CASE("mq without a bound has none to scale") {
  CHECK(MemorylessQuadric().scaled(0).max_distance == HUGE_VAL);
  MemorylessQuadric planner;
  planner.max_distance = 3;
  CHECK(planner.scaled(0.5).max_distance == 1.5);
}
