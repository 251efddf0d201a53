#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "catch.hh"
#include "charts.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "whittle/bulk.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/surface/charts.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

MemorylessQuadric seam_planner(std::size_t faces) {
  MemorylessQuadric planner;
  planner.target_faces = faces;
  return planner;
}

BulkOptions with_charts(const IndexedMesh& mesh, std::size_t size) {
  BulkOptions options;
  options.extras.wedges = meshes::wedges_of(mesh, meshes::grown_charts(mesh, size, 3));
  return options;
}

Charts charts_of(const IndexedMesh& mesh, const BulkOptions& options) {
  return charts(mesh.triangles, options.extras.wedges);
}

void check_same_topology(const IndexedMesh& before, const IndexedMesh& after) {
  const auto a = measure::facts(before), b = measure::facts(after);
  CHECK(b.nonmanifold_edges == 0);
  CHECK(b.nonmanifold_vertices == a.nonmanifold_vertices);
  CHECK(b.euler_characteristic == a.euler_characteristic);
  CHECK(b.boundary_loops == a.boundary_loops);
  CHECK(b.components == a.components);
}

}  // namespace

TEST_CASE("mq reaches its target among charts of any size, and keeps the topology") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const IndexedMesh hill = meshes::grid(
      40, [](std::uint32_t i, std::uint32_t j) { return std::sin(i * 0.3) * std::cos(j * 0.2); });
  for (const IndexedMesh& mesh : {torus, hill})
    for (const std::size_t size : {5u, 30u, 200u}) {
      const BulkOptions options = with_charts(mesh, size);
      const std::size_t target = mesh.triangles.size() / 8;
      const auto out = bulk(seam_planner(target), mesh, options);
      CHECK(out.mesh.triangles.size() <= target);
      check_same_topology(mesh, out.mesh);
      const Charts before = charts_of(mesh, options);
      CHECK(before.count > 6);
      CHECK(count_vanished(before, out.face_origin) < before.count);
    }
}

TEST_CASE("mq keeps every chart where it is told to") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const BulkOptions options = with_charts(mesh, 12);
  MemorylessQuadric planner = seam_planner(1);
  const Charts before = charts_of(mesh, options);
  CHECK(count_vanished(before, bulk(planner, mesh, options).face_origin) > before.count / 2);
  planner.keep_charts = true;
  const auto out = bulk(planner, mesh, options);
  CHECK(count_vanished(before, out.face_origin) == 0);
  CHECK(out.mesh.triangles.size() >= before.count);
  CHECK(out.record.refused_by_seam > 0);
}

TEST_CASE("mq keeps a straight seam straight, and every face on its side") {
  const IndexedMesh grid = meshes::shaken(meshes::flat_grid(31), 0.2, 6);
  IndexedMesh mesh = grid;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    mesh.points[v].z() = 0;
    if (v % 31 == 15) mesh.points[v].x() = 15;
  }
  BulkOptions options;
  const auto side = [](const meshes::Point& p) { return p.x() > 15 ? 1u : 0u; };
  options.extras.wedges = meshes::wedges_of(mesh, meshes::charts_by_centre(mesh, side));
  const auto out = bulk(seam_planner(40), mesh, options);
  CHECK(out.mesh.triangles.size() <= 40);
  const auto before = meshes::charts_by_centre(mesh, side), after = meshes::charts_by_centre(out.mesh, side);
  for (std::size_t f = 0; f < after.size(); ++f) CHECK(after[f] == before[out.face_origin[f]]);
}

TEST_CASE("mq leaves vertices on seams where they are if it does not know how the seams run") {
  const IndexedMesh mesh = meshes::flat_grid(12);
  BulkOptions options;
  options.extras.flags.assign(mesh.points.size(), 0);
  for (std::size_t v = 5; v < mesh.points.size(); v += 12) options.extras.flags[v] = kSeam;
  const auto held = bulk(seam_planner(20), mesh, options);
  for (std::size_t v = 5; v < mesh.points.size(); v += 12)
    CHECK(held.mesh.points[held.vertex_map[v]] == mesh.points[v]);

  options.extras.wedges = meshes::wedges_of(mesh, meshes::halves(mesh, 5));
  CHECK(bulk(seam_planner(20), mesh, options).mesh.triangles.size() <= 20);
}

TEST_CASE("planners that move no seams leave vertices where they are whose wedges differ") {
  const IndexedMesh mesh = meshes::flat_grid(12);
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(mesh, meshes::halves(mesh, 5));
  const SurfaceT<double> surface(mesh, extras);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
    CHECK(((surface.flags(v) & kSeam) != 0) == (v % 12 == 5));
  SphereScan planner;
  planner.radius = 1.1;
  BulkOptions options;
  options.extras = extras;
  const auto out = bulk(planner, mesh, options);
  CHECK(out.collapses > 0);
  for (std::size_t v = 5; v < mesh.points.size(); v += 12)
    CHECK(out.mesh.points[out.vertex_map[v]] == mesh.points[v]);
}

TEST_CASE("SS merges vertices on a seam two by two and halfway, whatever the placement") {
  // A ridge across the seam; the vertex where they meet comes first, with a neighbour on the seam on either side.
  IndexedMesh mesh =
      meshes::grid(9, [](std::uint32_t, std::uint32_t j) { return -0.5 * std::abs(double(j) - 4); });
  std::swap(mesh.points[0], mesh.points[40]);
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = v == 0 ? 40 : v == 40 ? 0 : v;
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(mesh, meshes::halves(mesh, 4));
  const SurfaceT<double> surface(mesh, extras);
  SphereScan planner;
  planner.radius = 1.2;
  planner.seams = Seams::merge;
  for (const auto placement : {SphereScan::Placement::paper, SphereScan::Placement::quadric}) {
    planner.placement = placement;
    std::vector<std::uint32_t> gone;
    for (const Collapse& collapse : planner.plan(surface).collapses) {
      if (!surface.is_on_seam(collapse.to)) continue;
      gone.push_back(collapse.from);
      CHECK(collapse.rest == 0);
      CHECK(collapse.target.isApprox((surface.point(collapse.from) + surface.point(collapse.to)) / 2, 1e-15));
    }
    CHECK(gone.size() == 3);
  }
}

TEST_CASE("the ends of a slit are on a seam for every planner") {
  const IndexedMesh mesh = meshes::flat_grid(5);
  SurfaceExtras extras;
  for (const auto& t : mesh.triangles) extras.wedges.push_back(t);
  for (const std::size_t f : {13u, 20u, 21u}) {  // the faces right of the edges from 7 over 12 to 17
    auto& corners = extras.wedges[f];
    for (std::uint32_t& wedge : corners) wedge += wedge == 12 ? 100 : 0;
  }
  const SurfaceT<double> surface(mesh, extras);
  for (std::uint32_t v = 0; v < 25; ++v)
    CHECK(std::pair(v, (surface.flags(v) & kSeam) != 0) == std::pair(v, v == 7 || v == 12 || v == 17));
}

TEST_CASE("mq keeps the bound on the distance along seams, and features beside them") {
  const IndexedMesh mesh = meshes::grid(40, [](std::uint32_t i, std::uint32_t j) {
    return 0.5 * std::abs(20.0 - i) + 0.5 * std::sin(j * 0.4);
  });
  const BulkOptions options = with_charts(mesh, 60);
  MemorylessQuadric planner;
  planner.max_distance = 0.1;
  planner.feature_angle = 30;
  const auto out = bulk(planner, mesh, options);
  CHECK(out.mesh.triangles.size() < mesh.triangles.size() / 2);
  check_same_topology(mesh, out.mesh);
  const measure::Distance d = measure::distance(mesh, out.mesh);
  CHECK(d.two_sided.max < 0.15);
}

TEST_CASE("mq plans the same among charts on any number of threads") {
  const IndexedMesh mesh = meshes::riddled(meshes::shaken(meshes::torus(160, 80), 0.001, 1), 80, 3);
  for (const std::size_t size : {6u, 100u}) {
    BulkOptions options = with_charts(mesh, size);
    options.threads = 1;
    const auto one = bulk(seam_planner(5000), mesh, options);
    CHECK(one.mesh.triangles.size() <= 5000);
    for (const std::size_t n_threads : {3u}) {
      options.threads = n_threads;
      const auto many = bulk(seam_planner(5000), mesh, options);
      REQUIRE(many.mesh.triangles == one.mesh.triangles);
      REQUIRE(many.mesh.points == one.mesh.points);
    }
  }
}

TEST_CASE("in passes mq moves the seams that the pass before has left") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const BulkOptions options = with_charts(mesh, 40);
  const SurfaceT<double> surface(mesh, options.extras);
  StagesT<double> stages(surface);
  stages.add(seam_planner(1200));
  stages.add(seam_planner(300));
  CHECK(stages.n_faces() <= 300);
  const CollapsePlan plan = stages.take();
  CHECK(plan.stages.size() == 2);
  const auto out = execute(plan, mesh);
  check_same_topology(mesh, out.mesh);
  const Charts before = charts_of(mesh, options);
  CHECK(count_vanished(before, out.face_origin) < before.count);
}
