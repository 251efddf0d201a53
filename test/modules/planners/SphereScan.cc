#include "whittle/planners/SphereScan.hh"

#include "catch.hh"
#include "meshes.hh"
#include "planners/acute.hh"
#include "whittle/plan/execute.hh"

using namespace whittle;
using Eigen::Vector3d;
using meshes::acute, meshes::kA, meshes::kB, meshes::kC;
using meshes::IndexedMesh;
using meshes::Merges;

namespace {

CollapsePlan plan(const SphereScan& planner, const IndexedMesh& mesh, std::vector<std::uint8_t> flags = {},
                  std::vector<float> tolerance = {}) {
  return planner.plan(SurfaceT<double>(mesh, {std::move(flags), std::move(tolerance), {}}));
}

SphereScan within(double radius, double min_cos = 0.2) {
  SphereScan planner;
  planner.radius = radius;
  planner.guard.min_cos = min_cos;
  return planner;
}

SphereScan quadric(double radius) {
  SphereScan planner = within(radius);
  planner.placement = SphereScan::Placement::quadric;
  return planner;
}

SphereScan merging(double radius) {
  SphereScan planner = within(radius);
  planner.boundary = Boundary::merge;
  return planner;
}

/// Flags that leave only the given vertices free.
std::vector<std::uint8_t> only(const IndexedMesh& mesh, const std::vector<std::uint32_t>& free) {
  std::vector<std::uint8_t> flags(mesh.points.size(), kLocked);
  for (const std::uint32_t v : free) flags[v] = 0;
  return flags;
}

}  // namespace

TEST_CASE("SS merges a neighbour just inside of the radius and keeps it just outside") {
  CHECK(plan(within(0.25 - 1e-12), acute()).collapses.empty());
  CHECK(plan(within(0.25), acute()).collapses.empty());  // nearer than the radius, not as near
  const CollapsePlan merged = plan(within(0.25 + 1e-12), acute());
  REQUIRE(meshes::merges(merged) == Merges{{1, 0}});
  CHECK(merged.collapses[0].target == Vector3d(0.125, 0, 0));  // two: the midpoint
  CHECK(merged.record.planned == 1);
}

TEST_CASE("SS merges three vertices to the centre of their circle") {
  SECTION("an acute triangle") {
    const CollapsePlan merged = plan(within(0.5), acute());
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[0].to == 0);
    CHECK(merged.collapses[1].target.isApprox(detail::circumcenter(kA, kB, kC), 1e-15));
  }
  SECTION("an obtuse triangle") {
    const CollapsePlan merged =
        plan(within(1), meshes::triangle_in_hexagon({-0.25, 0, 0}, {0.25, 0, 0}, {0.125, 0.125, 0}, 1));
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[1].target == Vector3d(0, 0, 0));
  }
}

TEST_CASE("SS merges more than three vertices to their centroid") {
  IndexedMesh mesh = meshes::flat_grid(4);
  mesh.points[10] = {1.75, 1.75, 0};
  const CollapsePlan merged = plan(within(1.5), mesh);
  REQUIRE(merged.collapses.size() == 3);
  for (const Collapse& c : merged.collapses) {
    CHECK(c.to == 5);
    CHECK(c.target == Vector3d(1.4375, 1.4375, 0));
  }
  CHECK(merged.record.planned == 1);
}

TEST_CASE("SS merges neighbours in the ring, not what is merely near") {
  IndexedMesh mesh = acute();
  const IndexedMesh above = acute();
  for (const Vector3d& p : above.points) mesh.points.emplace_back(p + Vector3d(0, 0, 0.01));
  for (const auto& t : above.triangles) mesh.triangles.push_back({t[0] + 9, t[1] + 9, t[2] + 9});
  CHECK(plan(within(0.2), mesh).collapses.empty());
  CHECK(meshes::merges(plan(within(0.26), mesh)) == Merges{{1, 0}, {10, 9}});
}

TEST_CASE("SS scans vertices in index order and merges a vertex once") {
  // The inner vertices of the 5 x 5 grid are 6 7 8, 11 12 13, 16 17 18. The radius reaches along the rows and
  // columns, not over a diagonal.
  const CollapsePlan merged = plan(within(1.1), meshes::flat_grid(5));
  REQUIRE(merged.record.planned == 3);
  CHECK(merged.record.refused_by_link + merged.record.refused_by_flip_guard == 0);
  std::vector<std::set<std::uint32_t>> clusters(25);
  for (const Collapse& c : merged.collapses) clusters[c.to].insert(c.from);
  CHECK(clusters[6] == std::set<std::uint32_t>{7, 11});
  CHECK(clusters[8] == std::set<std::uint32_t>{13});
  CHECK(clusters[12] == std::set<std::uint32_t>{17});  // 7, 11 and 13 are taken; 16 and 18 merge nothing
  CHECK(merged.collapses.size() == 4);
  CHECK(merged.collapses.front().to == 6);
  CHECK(merged.collapses.back().to == 12);
  CHECK(merged.collapses.back().target == Vector3d(2, 2.5, 0));
}

TEST_CASE("SS merges with the nearest neighbour where the whole is refused") {
  // The centre of 0 1 2 lies beyond the edge 6 7, the middle of 0 1 does not.
  IndexedMesh mesh = meshes::triangle_in_hexagon({0, 0, 0}, {0.2, 0, 0}, {0.1, 0.6, 0}, 1);
  mesh.points[6] = {0.8, -0.5, 0};
  mesh.points[7] = {0.25, 0.05, 0};
  mesh.points[8] = {0.3, 1, 0};
  const CollapsePlan merged = plan(within(0.7), mesh);
  REQUIRE(meshes::merges(merged) == Merges{{1, 0}});
  CHECK(merged.collapses[0].target == Vector3d(0.1, 0, 0));
  CHECK(merged.record.planned == 1);
  CHECK(merged.record.fell_back == 1);
  CHECK(merged.record.refused_by_flip_guard == 0);
  CHECK(plan(within(0.7, -1), mesh).collapses.size() == 2);
}

TEST_CASE("SS takes the nearest neighbour alone, wherever it is in the ring") {
  // As before with 1 and 2 exchanged, so that the far neighbour comes first.
  IndexedMesh mesh = meshes::triangle_in_hexagon({0, 0, 0}, {0.2, 0, 0}, {0.1, 0.6, 0}, 1);
  mesh.points[6] = {0.8, -0.5, 0};
  mesh.points[7] = {0.25, 0.05, 0};
  mesh.points[8] = {0.3, 1, 0};
  std::swap(mesh.points[1], mesh.points[2]);
  for (auto& t : mesh.triangles)
    for (auto& v : t) v = v == 1 ? 2 : v == 2 ? 1 : v;
  CHECK(meshes::merges(plan(within(0.7), mesh)) == Merges{{2, 0}});
}

TEST_CASE("SS counts once what it can merge neither whole nor in part") {
  const CollapsePlan refused = plan(within(10, -1), meshes::tetrahedron());
  CHECK(refused.collapses.empty());
  CHECK(refused.record.refused_by_link == 4);  // once for each vertex
  CHECK(refused.record.fell_back == 0);
}

TEST_CASE("SS with quadric placement finds the corner of a cube") {
  // The planes are orthogonal and equally heavy, so the pull keeps 3 parts in 100003 of the distance.
  const CollapsePlan merged = plan(quadric(0.15), meshes::cube_corner(0.1));
  REQUIRE(merged.collapses.size() == 3);
  CHECK(merged.collapses[2].to == 0);
  CHECK((merged.collapses[2].target - Vector3d::Constant(0.025 * 3e-5 / (1 + 3e-5))).norm() < 1e-13);
  CHECK(plan(within(0.15), meshes::cube_corner(0.1)).collapses[2].target.isApprox(Vector3d::Constant(0.025)));
}

TEST_CASE("SS with quadric placement passes over faces without area") {
  // A second vertex in the place of 4 adds such a face to the star of 1.
  IndexedMesh mesh = meshes::cube_corner(0.1);
  REQUIRE(mesh.triangles[0] == IndexedMesh::Triangle{7, 4, 1});
  mesh.points.push_back(mesh.points[4]);
  mesh.triangles[0] = {7, 10, 1};
  mesh.triangles.push_back({10, 4, 1});
  const CollapsePlan merged = plan(quadric(0.15), mesh);
  REQUIRE(merged.collapses.size() == 3);
  CHECK((merged.collapses[2].target - Vector3d::Constant(0.025 * 3e-5 / (1 + 3e-5))).norm() < 1e-13);
}

TEST_CASE("SS with quadric placement finds an edge and slides not along it") {
  // A roof with a ridge over x = 2, its two sides orthogonal. 11 lies on one side, 12 on the ridge: 9 faces
  // pull to the side, which the midpoint is on already, and 3 to the other one.
  const IndexedMesh mesh = meshes::grid(5, [](std::uint32_t i, std::uint32_t) { return -std::abs(i - 2.0); });
  const CollapsePlan merged = plan(quadric(1.5), mesh, only(mesh, {11, 12}));
  REQUIRE(meshes::merges(merged) == Merges{{12, 11}});
  const double part = 3 / (3 + 12e-5);
  CHECK(merged.collapses[0].target.isApprox(Vector3d(1.5, 2, -0.5) + part * Vector3d(0.5, 0, 0.5), 1e-12));
}

TEST_CASE("SS with quadric placement stays where it was on a plane") {
  const IndexedMesh mesh = meshes::flat_grid(5);
  const CollapsePlan paper = plan(within(1.1), mesh), placed = plan(quadric(1.1), mesh);
  REQUIRE(meshes::merges(placed) == meshes::merges(paper));
  for (std::size_t i = 0; i < paper.collapses.size(); ++i)
    CHECK(placed.collapses[i].target == paper.collapses[i].target);
}

TEST_CASE("SS with quadric placement moves a vertex by at most half the radius") {
  // A narrow flat top between two steep sides, whose planes meet far above it.
  IndexedMesh mesh =
      meshes::grid(6, [](std::uint32_t i, std::uint32_t) { return i < 3 ? 3 * (i - 2.0) : -3 * (i - 3.0); });
  for (Vector3d& p : mesh.points)
    if (p.x() > 2.5) p.x() -= 0.9;  // the top is 0.1 wide
  SphereScan planner = quadric(0.11);
  planner.guard.min_cos = -1;
  const CollapsePlan merged = plan(planner, mesh, only(mesh, {14, 15}));
  REQUIRE(meshes::merges(merged) == Merges{{15, 14}});
  CHECK(merged.collapses[0].target.isApprox(Vector3d(2.05, 2, 0.055), 1e-9));
}

TEST_CASE("SS with radius 0 merges nothing") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon(kA, kA, kC, 1);
  CHECK(plan(within(0), mesh).collapses.empty());
  CHECK(plan(within(1e-9), mesh).collapses.size() == 1);
  CHECK(plan(within(1).scaled(0), mesh).collapses.empty());
}

TEST_CASE("SS keeps locked, feature, seam and complex vertices") {
  for (const std::uint8_t flag : {kLocked, kFeature, kSeam, kComplex}) {
    CHECK(meshes::merges(plan(within(1), acute(), {flag, 0, 0, 0, 0, 0, 0, 0, 0})) == Merges{{2, 1}});
    CHECK(meshes::merges(plan(within(1), acute(), {0, flag, 0, 0, 0, 0, 0, 0, 0})) == Merges{{2, 0}});
    CHECK(plan(within(1), acute(), {0, flag, flag, 0, 0, 0, 0, 0, 0}).collapses.empty());
  }
}

TEST_CASE("SS keeps the boundary") {
  CHECK(plan(within(10), meshes::cone(6, 0)).collapses.empty());
  CHECK(plan(within(10), meshes::flat_grid(3)).collapses.empty());
}

TEST_CASE("SS merges boundary vertices with one another where it may") {
  const IndexedMesh mesh = meshes::flat_grid(3);  // 4 is inside
  const CollapsePlan merged = plan(merging(1.1), mesh);
  REQUIRE_FALSE(merged.collapses.empty());
  for (const Collapse& c : merged.collapses) {
    CHECK(c.from != 4);
    CHECK(c.to != 4);
    CHECK(c.faces == 1);
  }
  CHECK(merged.collapses[0].to == 0);
  CHECK(merged.collapses[1].to == 0);
  CHECK(merged.collapses[0].from + merged.collapses[1].from == 1 + 3);
  CHECK(merged.collapses[0].target == Vector3d(0.5, 0.5, 0));
}

TEST_CASE("SS merges boundary vertices along boundary edges only") {
  // A strip, short across: its rungs are inner edges between boundary vertices, but for the first and last.
  const CollapsePlan merged = plan(merging(0.5), meshes::strip(4, 0.25));
  REQUIRE(meshes::merges(merged) == Merges{{4, 0}, {7, 3}});
  CHECK(merged.collapses[0].target == Vector3d(0, 0.125, 0));
  CHECK(merged.collapses[1].target == Vector3d(3, 0.125, 0));
  CHECK(merged.record.refused_by_link == 0);
}

TEST_CASE("SS never merges an inner vertex with the boundary") {
  IndexedMesh mesh = meshes::cone(6, 0);
  mesh.points[0] = {0.9, 0, 0};  // 0.1 from the boundary vertex 1
  CHECK(plan(merging(0.5), mesh).collapses.empty());
}

TEST_CASE("SS keeps a locked boundary vertex when the boundary may merge") {
  std::vector<std::uint8_t> flags(8, 0);
  flags[4] = kLocked;
  CHECK(meshes::merges(plan(merging(0.5), meshes::strip(4, 0.25), flags)) == Merges{{7, 3}});
}

TEST_CASE("SS multiplies the radius by the lesser tolerance of two vertices") {
  const auto merges = [](double radius, float a, float b) {
    return meshes::merges(plan(within(radius), acute(), {}, {a, b, 0, 1, 1, 1, 1, 1, 1}));
  };
  CHECK(merges(10, 0, 1).empty());
  CHECK(merges(10, 1, 0).empty());
  CHECK(merges(0.126, 2, 2) == Merges{{1, 0}});
  CHECK(merges(0.124, 2, 2).empty());
  CHECK(merges(0.126, 2, 1).empty());
  CHECK(merges(0.126, 1, 2).empty());
  CHECK(merges(0.5, 0.5, 1).empty());  // just as far
  CHECK(merges(0.51, 0.5, 1) == Merges{{1, 0}});
  CHECK(merges(0.51, 9, 0.5) == Merges{{1, 0}});
}

TEST_CASE("SS is not troubled by degenerate triangles") {
  for (SphereScan planner : {within(1), quadric(1)}) {
    planner.guard.min_cos = -1;
    for (const Collapse& c : plan(planner, meshes::triangle_in_hexagon(kA, kA, kB, 1)).collapses)
      CHECK(c.target.allFinite());

    IndexedMesh point = acute();
    for (Vector3d& p : point.points) p = kB;
    const CollapsePlan merged = plan(planner, point);
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[1].target == kB);

    IndexedMesh twice = acute();
    twice.triangles.push_back({2, 2, 0});  // makes 0 and 2 complex
    CHECK(plan(planner, twice).collapses.empty());
  }
}

TEST_CASE("SS leaves a mesh alone that has nothing to merge") {
  for (const SphereScan& planner : {within(10), merging(10)}) {
    CHECK(plan(planner, {}).collapses.empty());
    CHECK(plan(planner, meshes::lone_triangle()).collapses.empty());
    CHECK(plan(planner, meshes::isolated_points(3)).collapses.empty());
  }
}

TEST_CASE("SS refuses parameters that mean nothing") {
  for (const double radius : {-1.0, std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(within(radius).validate(), InvalidParameter);
    CHECK_THROWS_AS(plan(within(radius), acute()), InvalidParameter);
  }
  CHECK_THROWS_AS(plan(within(1, 1), acute()), InvalidParameter);
  CHECK_THROWS_AS(plan(within(1, std::nan("")), acute()), InvalidParameter);
}

TEST_CASE("SS's threshold scales") {
  CHECK(quadric(0.5).scaled(0.5).radius == 0.25);
  CHECK(quadric(0.5).scaled(0.5).placement == SphereScan::Placement::quadric);
}

TEST_CASE("SS takes the first of several nearest neighbours where the whole is refused") {
  // All edges of an octahedron are as long. The ring of 0 begins at its first face, 0 1 4, with 1.
  const CollapsePlan merged = plan(within(2, -1), meshes::octahedron());
  REQUIRE_FALSE(merged.collapses.empty());
  CHECK(merged.collapses[0].from == 1);
  CHECK(merged.collapses[0].to == 0);
}
