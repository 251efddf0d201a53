#include "whittle/mq/Bound.hh"

#include <algorithm>
#include <cmath>
#include <vector>

#include "OpenMeshFixture.hh"
#include "measure/ClosestFace.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/bulk.hh"

using namespace whittle;
using detail::Crew, detail::Rings;
using Eigen::Vector3d;
using Eigen::Vector3f;
using meshes::IndexedMesh;
using mq::Bound;

namespace {

MemorylessQuadric within(double distance, std::size_t faces = 0) {
  MemorylessQuadric planner;
  planner.max_distance = distance;
  planner.target_faces = faces;
  return planner;
}

/// How far points lie from a mesh.
std::vector<double> distances(const std::vector<Vector3d>& points, const IndexedMesh& mesh) {
  const measure::Surface surface(mesh);
  const measure::ClosestFace tree(surface, 1);
  std::vector<double> all;
  all.reserve(points.size());
  for (const Vector3d& p : points) all.push_back(std::sqrt(tree.closest(p).squared_distance));
  return all;
}

double farthest_vertex(const IndexedMesh& from, const IndexedMesh& to) {
  const std::vector<double> all = distances(from.points, to);
  return *std::max_element(all.begin(), all.end());
}

}  // namespace

TEST_CASE("mq's bound moves points to the nearest face, and refuses a collapse that takes one far from all") {
  // A point in the middle of four, on the faces 0 and 1 that are about to become the triangles of a square.
  const std::vector<Vector3f> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1.5f, 0.5f, 0.25f}};
  const std::vector<Rings::Triangle> input{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0}};
  Crew alone(1);
  const auto allowed = [&](float distance) {
    Bound bound(points, Rings(input, 5, false, alone), std::vector<float>(5, distance), 4);
    bound.put(4, 0);
    Bound::Change change;
    change.faces = {0, 1, 2, 3};
    change.triangles = {{2, points[2], points[3], points[0]}, {1, points[0], points[1], points[2]}};
    if (!bound.allows(change)) return false;
    REQUIRE(change.moves.size() == 1);
    CHECK(change.moves[0].first == 4);
    CHECK(change.moves[0].second == 1);
    return true;
  };
  CHECK(allowed(0.26f));
  CHECK_FALSE(allowed(0.24f));
}

TEST_CASE("mq's bound refuses a face that lies far from the input, though all points are near it") {
  // The input is a strip; the new face spans far to its side.
  const std::vector<Vector3f> points{{0, 0, 0}, {1, 0, 0}, {0, 0.1f, 0}};
  Crew alone(1);
  Bound bound(points, Rings({{0, 1, 2}}, 3, false, alone), std::vector<float>(3, 0.2f), 1);
  bound.put(0, 0);
  Bound::Change change;
  change.faces = {0};
  change.triangles = {{0, {0, 0, 0}, {1, 0, 0}, {0, 0.25f, 0}}};
  CHECK(bound.allows(change));
  change.triangles = {{0, {0, 0, 0}, {1, 0, 0}, {0, 3, 0}}};
  CHECK_FALSE(bound.allows(change));
}

TEST_CASE("mq keeps every vertex of the input within its largest distance, and goes on elsewhere") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  for (const double distance : {0.01, 0.05}) {
    const auto kept = bulk(within(distance), mesh);
    CHECK(farthest_vertex(mesh, kept.mesh) <= distance * 1.0001);
    // The same number of faces without the bound takes some vertex farther.
    const auto free = bulk(within(HUGE_VAL, kept.mesh.triangles.size()), mesh);
    CHECK(farthest_vertex(mesh, free.mesh) > distance);
    CHECK(kept.mesh.triangles.size() < mesh.triangles.size() / 2);
  }
}

TEST_CASE("every beginning of a bounded mq plan keeps the bound") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(32, 16), 0.004, 1);
  const CollapsePlan plan = within(0.02).plan(SurfaceT<double>(mesh));
  for (std::size_t n = 0; n < plan.collapses.size(); n += 60)
    CHECK(farthest_vertex(mesh, execute(plan, mesh, n).mesh) <= 0.02 * 1.0001);
}

TEST_CASE(
    "mq with a bound that nothing comes near plans as without one, and with one of 0 collapses nothing "
    "curved") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  BulkOptions options;
  options.refit = false;
  CHECK(bulk(within(100, 500), torus).mesh.points == bulk(within(HUGE_VAL, 500), torus, options).mesh.points);
  CHECK(bulk(within(0), torus).collapses == 0);
}

TEST_CASE("a vertex's tolerance is a factor of mq's bound") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  SurfaceExtras extras;
  extras.tolerance.assign(mesh.points.size(), 1);
  for (std::size_t v = 0; v < mesh.points.size() / 2; ++v) extras.tolerance[v] = 0.1f;
  const CollapsePlan plan = within(0.05).plan(SurfaceT<double>(mesh, extras));
  const std::vector<double> far = distances(mesh.points, execute(plan, mesh).mesh);
  double strict = 0, loose = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    double& most = extras.tolerance[v] < 1 ? strict : loose;
    most = std::max(most, far[v]);
  }
  CHECK(strict <= 0.005 * 1.001);
  CHECK(loose <= 0.05 * 1.001);
  CHECK(loose > 0.01);
}

TEST_CASE("a bounded mq plans the same on any number of threads, also where the mesh is cut into parts") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(180, 100), 0.0005, 1);
  REQUIRE(mesh.points.size() > 2 * 8192);
  BulkOptions options;
  options.threads = 1;
  const auto one = bulk(within(0.002), mesh, options);
  CHECK(one.collapses > 1000);
  for (const std::size_t n_threads : {3u}) {
    options.threads = n_threads;
    const auto many = bulk(within(0.002), mesh, options);
    CHECK(many.mesh.triangles == one.mesh.triangles);
    CHECK(many.mesh.points == one.mesh.points);
  }
}

TEST_CASE("mq's module has the bound, and scales it") {
  using Mesh = fixture::Mesh;
  const IndexedMesh indexed = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const auto faces = [&](double distance, double factor) {
    Mesh mesh = fixture::to_openmesh<Mesh>(indexed);
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    ModMemorylessQuadricT<Mesh>::Handle handle;
    decimater.add(handle);
    decimater.module(handle).set_max_distance(distance);
    decimater.module(handle).set_error_tolerance_factor(factor);
    return decimater.module(handle).plan().collapses.size();
  };
  CHECK(faces(0.01, 1) < faces(0.02, 1));
  CHECK(faces(0.01, 1) == faces(0.02, 0.5));
  CHECK(faces(HUGE_VAL, 0.5) > faces(0.02, 1));
  CHECK_THROWS_AS(within(-1).validate(), InvalidParameter);
  CHECK_THROWS_AS(within(std::nan("")).validate(), InvalidParameter);
}

namespace {

/// Whether a vertex 0 at the origin, in the first of the faces, may lie on the triangle instead.
bool may_become(const std::vector<Vector3f>& points, const std::vector<Rings::Triangle>& faces,
                const Vector3f& a, const Vector3f& b, const Vector3f& c, float distance) {
  Crew alone(1);
  Bound bound(points, Rings(faces, points.size(), false, alone), std::vector<float>(points.size(), distance),
              faces.size());
  bound.put(0, 0);
  Bound::Change change;
  change.faces = {0};
  change.triangles = {{0, a, b, c}};
  return bound.allows(change);
}

}  // namespace

TEST_CASE("mq's bound looks at the new vertex itself") {
  // Of a face whose first corner is lifted by h, every other sample lies at 2/3 h or lower.
  const std::vector<Vector3f> points{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  const auto lifted = [&](float h) {
    return may_become(points, {{0, 1, 2}}, {1, 0.5f, h}, {0, 0, 0}, {2, 0, 0}, 0.2f);
  };
  CHECK(lifted(0.19f));
  CHECK_FALSE(lifted(0.21f));
}

TEST_CASE("mq's bound looks at the middle, near each corner, and between the first two of a face") {
  // The input lacks the triangle a b 0 of the square; the middle of a b is 0.447 from it, other samples less.
  const std::vector<Vector3f> fan{{0, 0, 0}, {-1, -0.5f, 0}, {1, -0.5f, 0}, {1, 1, 0}, {-1, 1, 0}};
  const auto across = [&](float distance) {
    return may_become(fan, {{0, 2, 3}, {0, 3, 4}, {0, 4, 1}}, fan[1], fan[2], fan[0], distance);
  };
  CHECK(across(0.46f));
  CHECK_FALSE(across(0.43f));
  // The input ends at x = 1.5 or y = 1.5; a sample near a corner is 0.5 beyond, no other one.
  const std::vector<Vector3f> strip{{0, 0, 0}, {1.5f, 0, 0}, {1.5f, 3, 0}, {0, 3, 0}},
      lying{{0, 0, 0}, {3, 0, 0}, {3, 1.5f, 0}, {0, 1.5f, 0}};
  for (const auto& input : {strip, lying}) {
    const auto beyond = [&](float distance) {
      return may_become(input, {{0, 1, 2}, {0, 2, 3}}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, distance);
    };
    CHECK(beyond(0.51f));
    CHECK_FALSE(beyond(0.49f));
  }
}

TEST_CASE("mq's bound allows just its distance") {
  const std::vector<Vector3f> points{{0, 0, 0.25f}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  Crew alone(1);
  for (const float distance : {0.25f, 0.2499f}) {
    Bound bound(points, Rings({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 4, false, alone),
                std::vector<float>(4, distance), 3);
    bound.put(0, 0);
    Bound::Change change;
    change.faces = {0, 1, 2};
    change.triangles = {{0, points[1], points[2], points[3]}};
    CHECK(bound.allows(change) == (distance == 0.25f));
  }
}
