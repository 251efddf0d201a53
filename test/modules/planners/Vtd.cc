#include "whittle/planners/Vtd.hh"

#include <algorithm>
#include <vector>

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

CollapsePlan plan(const Vtd& planner, const IndexedMesh& mesh, std::vector<std::uint8_t> flags = {},
                  std::vector<float> tolerance = {}) {
  return planner.plan(SurfaceT<double>(mesh, {std::move(flags), std::move(tolerance), {}}));
}

Vtd below(double distance, double min_cos = 0.2) {
  Vtd planner;
  planner.max_distance = distance;
  planner.guard.min_cos = min_cos;
  return planner;
}

Vtd literal(double distance, double min_cos = 0.2) {
  Vtd planner = below(distance, min_cos);
  planner.fold = Vtd::Fold::literal;
  return planner;
}

Vtd along_boundary(double distance) {
  Vtd planner = below(distance);
  planner.boundary = Boundary::merge;
  return planner;
}

/// A triangle of edges 0.25, 0.3125 and 0.375 in a hexagon, its short edge opposite to corner `across`; the
/// mesh is the same for all three, only the corners' numbers turn.
IndexedMesh scalene(int across) {
  // The edge from (0, 0) to (0.25, 0); the third corner is 0.375 from the first and 0.3125 from the second.
  const Vector3d third(0.2109375, std::sqrt(0.140625 - 0.2109375 * 0.2109375), 0);
  const std::array<Vector3d, 3> corner{third, {0, 0, 0}, {0.25, 0, 0}};
  const auto at = [&](int i) { return corner[(i - across + 3) % 3]; };
  IndexedMesh mesh = meshes::triangle_in_hexagon(at(0), at(1), at(2), 1);
  std::rotate(mesh.points.begin() + 3, mesh.points.begin() + 3 + 2 * (2 - across), mesh.points.end());
  return mesh;
}

}  // namespace

TEST_CASE("VTD merges a triangle with three short edges as VT does, and folds an edge otherwise") {
  const double longer = std::sqrt(0.15625);
  const CollapsePlan whole = plan(below(longer + 1e-12), acute());
  REQUIRE(meshes::merges(whole) == Merges{{1, 0}, {2, 0}});
  CHECK(whole.collapses[1].target.isApprox(detail::circumcenter(kA, kB, kC), 1e-15));
  CHECK(whole.record.planned == 1);

  const CollapsePlan edge = plan(below(longer - 1e-12), acute());
  REQUIRE(meshes::merges(edge) == Merges{{1, 0}});
  CHECK(edge.collapses[0].target == Vector3d(0.125, 0, 0));
}

TEST_CASE("VTD folds an edge just inside of the threshold and keeps it just outside") {
  CHECK(plan(below(0.25 - 1e-12), acute()).collapses.empty());
  CHECK(plan(below(0.25), acute()).collapses.empty());  // an edge must be shorter, not as long
  CHECK(meshes::merges(plan(below(0.25 + 1e-12), acute())) == Merges{{1, 0}});
}

TEST_CASE("VTD folds an obtuse triangle to the middle of its longest edge, or to the literal circumcentre") {
  const Vector3d a(-0.25, 0, 0), b(0.25, 0, 0), c(0, 0.1875, 0);
  const IndexedMesh mesh = meshes::triangle_in_hexagon(a, b, c, 1);
  Vtd planner = below(0.6);
  REQUIRE(plan(planner, mesh).collapses.size() == 2);
  CHECK(plan(planner, mesh).collapses[1].target == Vector3d(0, 0, 0));
  planner.placement = Vtd::Placement::circumcenter;
  REQUIRE(plan(planner, mesh).collapses.size() == 2);
  CHECK(plan(planner, mesh).collapses[1].target.isApprox(detail::circumcenter(a, b, c), 1e-15));
}

TEST_CASE("VTD folds the shortest edge where not all three are short, whichever it is") {
  // With corner i across, the short edge goes from corner i + 1 to corner i + 2.
  for (const double distance : {0.26, 0.35}) {  // one short edge, two of them
    CHECK(meshes::merges(plan(below(distance), scalene(2))) == Merges{{1, 0}});
    CHECK(meshes::merges(plan(below(distance), scalene(0))) == Merges{{2, 1}});
    CHECK(meshes::merges(plan(below(distance), scalene(1))) == Merges{{0, 2}});
    for (int across = 0; across < 3; ++across)
      CHECK(plan(below(distance), scalene(across)).collapses[0].target == Vector3d(0.125, 0, 0));
  }
}

TEST_CASE("VTD to the letter folds the longer of the other two edges") {
  // The longest edge joins the first end of the short one and the corner across.
  for (const double distance : {0.26, 0.35}) {
    CHECK(meshes::merges(plan(literal(distance), scalene(2))) == Merges{{0, 2}});
    CHECK(meshes::merges(plan(literal(distance), scalene(0))) == Merges{{1, 0}});
    CHECK(meshes::merges(plan(literal(distance), scalene(1))) == Merges{{2, 1}});
    for (int across = 0; across < 3; ++across) {
      const IndexedMesh mesh = scalene(across);
      const Vector3d middle = (mesh.points[across] + mesh.points[(across + 1) % 3]) / 2;
      CHECK(plan(literal(distance), mesh).collapses[0].target == middle);
    }
  }
}

TEST_CASE("VTD to the letter asks for the first short edge, d12 before d13 before d23") {
  // Tolerances make the long edges short and the others not, so that the choice of the edge matters.
  // scalene(2): d12 = 0.25, d23 = 0.3125, d13 = 0.375.
  const IndexedMesh mesh = scalene(2);
  SECTION("d12 is short: the longer of d13 and d23") {
    CHECK(meshes::merges(plan(literal(0.3), mesh)) == Merges{{0, 2}});
  }
  SECTION("d13 alone is short: the longer of d12 and d23") {
    // 2 is less tolerant than 0, and 1 is hardly so.
    const std::vector<float> tolerance{1, 0.125f, 1, 1, 1, 1, 1, 1, 1};
    CHECK(meshes::merges(plan(literal(0.38), mesh, {}, tolerance)) == Merges{{2, 1}});
    CHECK(meshes::merges(plan(below(0.38), mesh, {}, tolerance)) == Merges{{0, 2}});
  }
  SECTION("d23 alone is short: the longer of d12 and d13") {
    const std::vector<float> tolerance{0.125f, 1, 1, 1, 1, 1, 1, 1, 1};
    CHECK(meshes::merges(plan(literal(0.38), mesh, {}, tolerance)) == Merges{{0, 2}});
    CHECK(meshes::merges(plan(below(0.38), mesh, {}, tolerance)) == Merges{{2, 1}});
  }
  SECTION("d13 and d23 are short, d12 is not: d13 is asked for, so that d23 folds, the longest") {
    // scalene(1): d13 = 0.25, d12 = 0.3125, d23 = 0.375, where 0 is less tolerant.
    const std::vector<float> tolerance{0.75f, 1, 1, 1, 1, 1, 1, 1, 1};
    CHECK(meshes::merges(plan(literal(0.4), scalene(1), {}, tolerance)) == Merges{{2, 1}});
    CHECK(meshes::merges(plan(below(0.4), scalene(1), {}, tolerance)) == Merges{{0, 2}});
  }
}

TEST_CASE("VTD to the letter prefers d12 to d13 and d23, even where it is not the shortest") {
  // One corner is less tolerant, so that two edges are short and the longest is one of them.
  SECTION("d12 = 0.25 and d13 = 0.375 are short, d23 = 0.3125 is not: d13 folds") {
    const std::vector<float> tolerance{1, 0.75f, 1, 1, 1, 1, 1, 1, 1};
    CHECK(meshes::merges(plan(literal(0.4), scalene(2), {}, tolerance)) == Merges{{0, 2}});
  }
  SECTION("d12 = 0.375 and d23 = 0.25 are short, d13 = 0.3125 is not: d13 folds") {
    const std::vector<float> tolerance{1, 1, 0.75f, 1, 1, 1, 1, 1, 1};
    CHECK(meshes::merges(plan(literal(0.4), scalene(0), {}, tolerance)) == Merges{{0, 2}});
    CHECK(meshes::merges(plan(below(0.4), scalene(0), {}, tolerance)) == Merges{{2, 1}});
  }
}

TEST_CASE("VTD to the letter takes d13 before d23 where both are as long") {
  CHECK(meshes::merges(plan(literal(0.26), acute())) == Merges{{0, 2}});
}

TEST_CASE("VTD takes the first of several shortest edges") {
  // Edges 0.25, 0.25 and 0.375.
  const IndexedMesh mesh =
      meshes::triangle_in_hexagon({-0.1875, 0, 0}, {0.1875, 0, 0}, {0, std::sqrt(0.02734375), 0}, 1);
  CHECK(meshes::merges(plan(below(0.26), mesh)) == Merges{{2, 1}});
}

TEST_CASE("VTD to the letter folds no edge whose ends are not free, and counts no refusal") {
  const CollapsePlan nothing = plan(literal(0.26), scalene(2), {0, 0, kLocked, 0, 0, 0, 0, 0, 0});
  CHECK(nothing.collapses.empty());
  CHECK(nothing.record.refused_by_flip_guard + nothing.record.refused_by_link == 0);
  CHECK(meshes::merges(plan(below(0.26), scalene(2), {0, 0, kLocked, 0, 0, 0, 0, 0, 0})) == Merges{{1, 0}});
}

TEST_CASE("VTD folds the shortest edge where the triangle is refused") {
  // The circumcentre of this needle is far off.
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.2, 0, 0}, {0.21, 0, 0}, {0, 0.01, 0}, 1);
  for (Vtd planner : {below(0.5), literal(0.5)}) {
    planner.placement = Vtd::Placement::circumcenter;
    const CollapsePlan folded = plan(planner, mesh);
    REQUIRE(meshes::merges(folded) == Merges{{0, 2}});
    CHECK(folded.record.fell_back == 1);
    CHECK(folded.record.refused_by_flip_guard == 0);
    CHECK(folded.collapses[0].target.isApprox(Vector3d(-0.1, 0.005, 0), 1e-15));
  }
}

TEST_CASE("VTD counts what it can merge neither whole nor in part") {
  const CollapsePlan refused = plan(below(10, -1), meshes::tetrahedron());
  CHECK(refused.collapses.empty());
  CHECK(refused.record.refused_by_link == 4);
  CHECK(refused.record.fell_back == 0);
}

TEST_CASE("VTD scans triangles in index order and merges a vertex once") {
  // Free are 5, 6, 9 and 10. A triangle with the boundary that has the edge 5 6 comes before the middle ones,
  // backwards one that has the edge 9 10.
  IndexedMesh mesh = meshes::flat_grid(4);
  const CollapsePlan folded = plan(below(1.5), mesh);
  CHECK(meshes::merges(folded) == Merges{{5, 6}, {9, 10}});
  CHECK(folded.collapses[0].target == Vector3d(1.5, 1, 0));
  CHECK(folded.collapses[1].target == Vector3d(1.5, 2, 0));
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  CHECK(meshes::merges(plan(below(1.5), mesh)) == Merges{{10, 9}, {6, 5}});
  std::swap(mesh.triangles[0], mesh.triangles[8]);  // 5 10 9 of the middle first
  CHECK(meshes::merges(plan(below(1.5), mesh)) == Merges{{10, 5}, {9, 5}});
}

TEST_CASE("VTD keeps locked, feature, seam and complex vertices") {
  for (const std::uint8_t flag : {kLocked, kFeature, kSeam, kComplex}) {
    CHECK(meshes::merges(plan(below(1), acute(), {flag, 0, 0, 0, 0, 0, 0, 0, 0})) == Merges{{2, 1}});
    CHECK(plan(below(1), acute(), {flag, 0, flag, 0, 0, 0, 0, 0, 0}).collapses.empty());
  }
}

TEST_CASE("VTD keeps the boundary, or folds its edges") {
  const IndexedMesh mesh = meshes::flat_grid(3);
  CHECK(plan(below(10), mesh).collapses.empty());
  const CollapsePlan folded = plan(along_boundary(1.1), mesh);
  REQUIRE(meshes::merges(folded) == Merges{{1, 0}, {5, 2}, {6, 7}});
  CHECK(folded.collapses[0].target == Vector3d(0.5, 0, 0));
  CHECK(folded.collapses[1].target == Vector3d(2, 0.5, 0));
  CHECK(folded.collapses[2].target == Vector3d(0.5, 2, 0));
}

TEST_CASE("VTD folds an edge of three boundary vertices, never the triangle") {
  // The corner 6 of the 3 x 3 grid and its two neighbours 3 and 7; all others are locked.
  IndexedMesh mesh = meshes::flat_grid(3);
  REQUIRE(mesh.triangles[5] == IndexedMesh::Triangle{3, 7, 6});
  mesh.triangles[5] = {6, 3, 7};
  std::vector<std::uint8_t> flags(9, kLocked);
  flags[3] = flags[6] = flags[7] = 0;
  const CollapsePlan folded = plan(along_boundary(1.5), mesh, flags);
  REQUIRE(meshes::merges(folded) == Merges{{3, 6}});
  CHECK(folded.collapses[0].target == Vector3d(0, 1.5, 0));
}

TEST_CASE("VTD folds no inner edge between boundary vertices") {
  for (const Collapse& c : plan(along_boundary(0.5), meshes::strip(4, 0.25)).collapses) {
    CHECK(c.faces == 1);
    CHECK((c.to % 4 == 0 || c.to % 4 == 3));  // the rungs at the two ends
  }
}

TEST_CASE("VTD never merges an inner vertex with the boundary") {
  IndexedMesh mesh = meshes::cone(6, 0);
  mesh.points[0] = {0.9, 0, 0};  // 0.1 from the boundary vertex 1
  CHECK(plan(along_boundary(0.5), mesh).collapses.empty());
}

TEST_CASE("VTD multiplies the distance by the lesser tolerance of two vertices") {
  const auto merges = [](double distance, float a, float b) {
    return meshes::merges(plan(below(distance), acute(), {}, {a, b, 0, 1, 1, 1, 1, 1, 1}));
  };
  CHECK(merges(10, 0, 1).empty());
  CHECK(merges(0.126, 2, 2) == Merges{{1, 0}});
  CHECK(merges(0.124, 2, 2).empty());
  CHECK(merges(0.126, 2, 1).empty());
  CHECK(merges(0.126, 1, 2).empty());
  CHECK(merges(0.51, 0.5, 9) == Merges{{1, 0}});
}

TEST_CASE("VTD is not troubled by degenerate triangles") {
  SECTION("two corners in one place") {
    const CollapsePlan folded = plan(below(0.01), meshes::triangle_in_hexagon(kA, kA, kC, 1));
    REQUIRE(meshes::merges(folded) == Merges{{1, 0}});
    CHECK(folded.collapses[0].target == kA);
  }
  SECTION("three corners in one place") {
    const CollapsePlan merged = plan(below(0.01), meshes::triangle_in_hexagon(kB, kB, kB, 1));
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[1].target == kB);
  }
}

TEST_CASE("VTD places no vertex at infinity, not even with the literal circumcentre and without the guard") {
  Vtd planner = below(1, -1);
  planner.placement = Vtd::Placement::circumcenter;
  for (const Collapse& c : plan(planner, meshes::triangle_in_hexagon(kA, kA, kC, 1)).collapses)
    CHECK(c.target.allFinite());
}

TEST_CASE("VTD with distance 0 merges nothing") {
  CHECK(plan(below(0), meshes::triangle_in_hexagon(kA, kA, kA, 1)).collapses.empty());
}

TEST_CASE("VTD leaves a mesh alone that has nothing to merge") {
  for (const Vtd& planner : {below(10), literal(10), along_boundary(10)}) {
    CHECK(plan(planner, {}).collapses.empty());
    CHECK(plan(planner, meshes::lone_triangle()).collapses.empty());
    CHECK(plan(planner, meshes::isolated_points(3)).collapses.empty());
  }
}

TEST_CASE("VTD refuses parameters that mean nothing") {
  for (const double distance : {-1.0, std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(below(distance).validate(), InvalidParameter);
    CHECK_THROWS_AS(plan(below(distance), acute()), InvalidParameter);
  }
  CHECK_THROWS_AS(plan(below(1, 1), acute()), InvalidParameter);
  CHECK_THROWS_AS(plan(below(1, std::nan("")), acute()), InvalidParameter);
}

TEST_CASE("VTD's threshold scales") {
  CHECK(literal(0.5).scaled(0.5).max_distance == 0.25);
  CHECK(literal(0.5).scaled(0.5).fold == Vtd::Fold::literal);
}

TEST_CASE("VTD to the letter merges a vertex once") {
  for (const IndexedMesh& mesh : {meshes::flat_grid(9), meshes::shaken(meshes::torus(12, 9), 0.02, 1)}) {
    Vtd planner;
    planner.max_distance = mesh.points.size() == 81 ? 1.2 : 0.3;
    planner.fold = Vtd::Fold::literal;
    const CollapsePlan plan = planner.plan(SurfaceT<double>(mesh));
    REQUIRE(plan.collapses.size() > 10);
    std::vector<int> clusters(mesh.points.size(), 0);
    for (const Collapse& c : plan.collapses) {
      ++clusters[c.from];
      if (c.rest == 0) ++clusters[c.to];
    }
    CHECK(*std::max_element(clusters.begin(), clusters.end()) == 1);
  }
}
