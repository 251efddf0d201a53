#include "whittle/planners/VertexDistance.hh"

#include <algorithm>
#include <utility>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/plan/execute.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

CollapsePlan plan(const VertexDistance& planner, const IndexedMesh& mesh,
                  std::vector<std::uint8_t> flags = {}) {
  return planner.plan(SurfaceT<double>(mesh, {std::move(flags), {}, {}}));
}

VertexDistance folding(double distance) {
  VertexDistance planner;
  planner.max_distance = distance;
  return planner;
}

const Eigen::Vector3d kP(0, 0, 0), kQ(0.2, 0, 0), kR(0.1, 0.3, 0);  // edges 0.2, 0.3162, 0.3162
IndexedMesh slim() {
  return meshes::triangle_in_hexagon(kP, kQ, kR, 1);
}

}  // namespace

TEST_CASE("IVDD folds an edge just inside of the threshold and keeps it just outside") {
  CHECK(plan(folding(0.2 - 1e-12), slim()).collapses.empty());
  CHECK(plan(folding(0.2), slim()).collapses.empty());  // an edge must be shorter, not as long
  const CollapsePlan folded = plan(folding(0.2 + 1e-12), slim());
  REQUIRE(folded.collapses.size() == 1);
  CHECK(folded.collapses[0].to == 0);
  CHECK(folded.collapses[0].from == 1);
  CHECK(folded.collapses[0].target == Eigen::Vector3d(0.1, 0, 0));
  CHECK(folded.record.fell_back == 0);  // no triangle was tried before
}

TEST_CASE("IVDD folds a triangle with two short edges to the centre of its circle") {
  const double longer = std::sqrt(0.1);
  CHECK(plan(folding(longer - 1e-12), slim()).collapses.size() == 1);
  const IndexedMesh mesh = slim();
  const auto out = execute(plan(folding(longer + 1e-12), mesh), mesh);
  CHECK(out.mesh.points.size() == 7);
  CHECK(out.mesh.triangles.size() == 6);
  CHECK(out.mesh.points[0].isApprox(detail::circumcenter(kP, kQ, kR), 1e-15));
}

TEST_CASE("IVDD needs two short edges to fold a triangle, whichever they are") {
  // Edges 0.2, 0.2 and 0.38: two are short, the third is not.
  const IndexedMesh mesh =
      meshes::triangle_in_hexagon({-0.19, 0, 0}, {0.19, 0, 0}, {0, 0.0624499799839840, 0}, 1);
  const CollapsePlan folded = plan(folding(0.21), mesh);
  REQUIRE(folded.collapses.size() == 2);
  CHECK(folded.collapses[0].target == Eigen::Vector3d(0, 0, 0));  // obtuse: the middle of the longest edge
}

TEST_CASE("IVDD with the literal circumcentre is off the triangle, or falls back") {
  VertexDistance planner = folding(0.5);
  planner.placement = VertexDistance::Placement::circumcenter;
  SECTION("a little off, where the guard allows it") {
    const Eigen::Vector3d a(-0.2, 0, 0), b(0.2, 0, 0), c(0, 0.15, 0);
    const CollapsePlan folded = plan(planner, meshes::triangle_in_hexagon(a, b, c, 1));
    REQUIRE(folded.collapses.size() == 2);
    CHECK(folded.collapses[0].target.isApprox(detail::circumcenter(a, b, c), 1e-15));
    CHECK(folded.collapses[0].target.y() < 0);
  }
  SECTION("far off: the triangle is refused and its shortest edge folds") {
    const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.2, 0, 0}, {0.21, 0, 0}, {0, 0.01, 0}, 1);
    const CollapsePlan folded = plan(planner, mesh);
    REQUIRE(folded.collapses.size() == 1);
    CHECK(folded.collapses[0].from + folded.collapses[0].to == 2);  // the edge 2 - 0
    CHECK(folded.record.fell_back == 1);
    CHECK(folded.record.refused_by_flip_guard == 0);
  }
}

TEST_CASE("IVDD leaves a fold that would flip a face, and counts it") {
  // The hexagon's corner 5 is pushed in, so that the face 0 4 5 turns over when 0 moves to the middle of the
  // edge 0 1. The third vertex is locked, which leaves that one edge to fold.
  IndexedMesh mesh = meshes::triangle_in_hexagon({-0.3, 0, 0}, {0.3, 0, 0}, {0, 0.6, 0}, 1);
  mesh.points[4] = {-0.4, -0.3, 0};
  mesh.points[5] = {-0.1, -0.05, 0};
  const std::vector<std::uint8_t> flags{0, 0, kLocked, 0, 0, 0, 0, 0, 0};
  VertexDistance planner = folding(0.65);
  const CollapsePlan refused = plan(planner, mesh, flags);
  CHECK(refused.collapses.empty());
  CHECK(refused.record.refused_by_flip_guard == 2);  // once for each face that has the edge
  planner.guard.min_cos = -1;
  CHECK(plan(planner, mesh, flags).collapses.size() == 1);
}

TEST_CASE("IVDD keeps boundary, locked and feature vertices") {
  const IndexedMesh mesh = slim();
  CHECK(plan(folding(10), mesh).collapses.size() == 2);  // the hexagon's edges are shorter, too, but stay
  for (const std::uint8_t flag : {kLocked, kFeature}) {
    const CollapsePlan folded = plan(folding(10), mesh, {flag, 0, 0, 0, 0, 0, 0, 0, 0});
    REQUIRE(folded.collapses.size() == 1);
    CHECK(folded.collapses[0].to == 1);
    CHECK(folded.collapses[0].from == 2);
    CHECK(plan(folding(10), mesh, {flag, flag, 0, 0, 0, 0, 0, 0, 0}).collapses.empty());
  }
}

TEST_CASE("IVDD folds a vertex at most once a pass") {
  for (const auto& [mesh, distance] :
       {std::pair(meshes::torus(12, 9), 0.3), std::pair(meshes::flat_grid(9), 1.2)}) {
    const CollapsePlan folded = plan(folding(distance), mesh);
    REQUIRE(folded.collapses.size() > 10);
    std::vector<int> clusters(mesh.points.size(), 0);
    for (std::size_t i = 0; i < folded.collapses.size(); ++i) {
      const Collapse& c = folded.collapses[i];
      ++clusters[c.from];
      if (i == 0 || folded.collapses[i - 1].to != c.to) ++clusters[c.to];
    }
    CHECK(*std::max_element(clusters.begin(), clusters.end()) == 1);
    CHECK(folded.record.refused_by_link == 0);  // what has folded is not tried again
  }
}

TEST_CASE("IVDD does not try again any of the three vertices that a triangle has taken") {
  IndexedMesh mesh = meshes::flat_grid(6);  // the diagonals are longer
  std::swap(mesh.triangles[0],
            *std::find(mesh.triangles.begin(), mesh.triangles.end(), IndexedMesh::Triangle{14, 15, 21}));
  const CollapsePlan folded = plan(folding(1.2), mesh);
  CHECK(meshes::merges(folded) ==
        meshes::Merges{{15, 14}, {21, 14}, {7, 8}, {9, 10}, {19, 13}, {22, 16}, {26, 20}, {27, 28}});
  CHECK(folded.record.refused_by_link + folded.record.refused_by_flip_guard + folded.record.fell_back == 0);
}

TEST_CASE("IVDD is not troubled by degenerate triangles") {
  IndexedMesh mesh = slim();
  mesh.points[1] = mesh.points[0];  // an edge of length 0
  const CollapsePlan folded = plan(folding(0.01), mesh);
  REQUIRE(folded.collapses.size() == 1);
  CHECK(folded.collapses[0].target == mesh.points[0]);
}

TEST_CASE("IVDD with distance 0 folds nothing") {
  IndexedMesh mesh = slim();
  mesh.points[1] = mesh.points[0];
  CHECK(plan(folding(0), mesh).collapses.empty());
}

TEST_CASE("IVDD refuses parameters that mean nothing") {
  for (const double distance : {-1.0, std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(folding(distance).validate(), InvalidParameter);
    CHECK_THROWS_AS(plan(folding(distance), slim()), InvalidParameter);
  }
  VertexDistance planner = folding(1);
  planner.guard.min_cos = 2;
  CHECK_THROWS_AS(planner.validate(), InvalidParameter);
}

TEST_CASE("IVDD's threshold scales") {
  CHECK(folding(0.5).scaled(0.5).max_distance == 0.25);
}

TEST_CASE("IVDD multiplies the distance by the lesser tolerance of two vertices") {
  const auto merges = [](double distance, float a, float b) {
    const IndexedMesh mesh = slim();
    return meshes::merges(
        folding(distance).plan(SurfaceT<double>(mesh, {{}, {a, b, 0, 1, 1, 1, 1, 1, 1}, {}})));
  };
  const meshes::Merges one{{1, 0}};
  CHECK(merges(10, 0, 1).empty());
  CHECK(merges(10, 1, 0).empty());
  CHECK(merges(0.101, 2, 2) == one);
  CHECK(merges(0.099, 2, 2).empty());
  CHECK(merges(0.101, 2, 1).empty());
  CHECK(merges(0.101, 1, 2).empty());
  CHECK(merges(0.399, 0.5, 1).empty());
  CHECK(merges(0.401, 0.5, 9) == one);
}

TEST_CASE("IVDD's tolerances count for each edge of a triangle") {
  // The tolerant edge 0 1 is short, those at 2 are not: no triangle, but an edge.
  const IndexedMesh mesh = slim();
  const auto merges = [&](float c) {
    return meshes::merges(folding(0.4).plan(SurfaceT<double>(mesh, {{}, {1, 1, c, 1, 1, 1, 1, 1, 1}, {}})));
  };
  CHECK(merges(1) == meshes::Merges{{1, 0}, {2, 0}});
  CHECK(merges(0.75) == meshes::Merges{{1, 0}});
}

TEST_CASE("IVDD folds boundary edges to their midpoint where it may, and keeps them otherwise") {
  const IndexedMesh mesh = meshes::flat_grid(3);
  VertexDistance planner = folding(1.1);
  CHECK(plan(planner, mesh).collapses.empty());
  planner.boundary = Boundary::merge;
  const CollapsePlan folded = plan(planner, mesh);
  REQUIRE(meshes::merges(folded) == meshes::Merges{{1, 0}, {5, 2}, {6, 7}});
  CHECK(folded.collapses[0].target == Eigen::Vector3d(0.5, 0, 0));
  CHECK(folded.collapses[1].target == Eigen::Vector3d(2, 0.5, 0));
  CHECK(folded.collapses[2].target == Eigen::Vector3d(0.5, 2, 0));
  for (const Collapse& c : folded.collapses) CHECK(c.faces == 1);
}

TEST_CASE("IVDD folds an edge of three boundary vertices, never the triangle") {
  // The corner 6 of the 3 x 3 grid and its two neighbours 3 and 7; all others are locked.
  IndexedMesh mesh = meshes::flat_grid(3);
  REQUIRE(mesh.triangles[5] == IndexedMesh::Triangle{3, 7, 6});
  mesh.triangles[5] = {6, 3, 7};
  std::vector<std::uint8_t> flags(9, kLocked);
  flags[3] = flags[6] = flags[7] = 0;
  VertexDistance planner = folding(1.5);
  planner.boundary = Boundary::merge;
  const CollapsePlan folded = plan(planner, mesh, flags);
  REQUIRE(meshes::merges(folded) == meshes::Merges{{3, 6}});
  CHECK(folded.collapses[0].target == Eigen::Vector3d(0, 1.5, 0));
}

TEST_CASE("IVDD folds no inner edge between boundary vertices, and none from inside to the boundary") {
  VertexDistance planner = folding(0.5);
  planner.boundary = Boundary::merge;
  for (const Collapse& c : plan(planner, meshes::strip(4, 0.25)).collapses) {
    CHECK(c.faces == 1);
    CHECK((c.to % 4 == 0 || c.to % 4 == 3));  // the rungs at the two ends
  }
  IndexedMesh cone = meshes::cone(6, 0);
  cone.points[0] = {0.9, 0, 0};  // 0.1 from the boundary vertex 1
  CHECK(plan(planner, cone).collapses.empty());
}

TEST_CASE("IVDD keeps a locked boundary vertex when the boundary may merge") {
  VertexDistance planner = folding(1.1);
  planner.boundary = Boundary::merge;
  const CollapsePlan folded = plan(planner, meshes::flat_grid(3), {kLocked, 0, 0, 0, 0, 0, 0, 0, 0});
  for (const Collapse& c : folded.collapses) CHECK((c.from != 0 && c.to != 0));
  CHECK(folded.collapses.size() == 3);
}

TEST_CASE("IVDD places no vertex at infinity, not even with the literal circumcentre and without the guard") {
  VertexDistance planner = folding(1);
  planner.placement = VertexDistance::Placement::circumcenter;
  planner.guard.min_cos = -1;
  for (const Collapse& c : plan(planner, meshes::triangle_in_hexagon(kP, kP, kR, 1)).collapses)
    CHECK(c.target.allFinite());
}

TEST_CASE("IVDD leaves a mesh alone that has nothing to fold") {
  for (const Boundary boundary : {Boundary::keep, Boundary::merge}) {
    VertexDistance planner = folding(10);
    planner.boundary = boundary;
    CHECK(plan(planner, {}).collapses.empty());
    CHECK(plan(planner, meshes::lone_triangle()).collapses.empty());
    CHECK(plan(planner, meshes::isolated_points(3)).collapses.empty());
  }
}

TEST_CASE("IVDD with quadric placement moves an edge's vertex by at most half the edge") {
  // A narrow flat top between two steep sides, whose planes meet far above it.
  IndexedMesh mesh =
      meshes::grid(6, [](std::uint32_t i, std::uint32_t) { return i < 3 ? 3 * (i - 2.0) : -3 * (i - 3.0); });
  for (auto& p : mesh.points)
    if (p.x() > 2.5) p.x() -= 0.9;  // the top is 0.1 wide
  VertexDistance planner = folding(0.11);
  planner.placement = VertexDistance::Placement::quadric;
  planner.guard.min_cos = -1;
  std::vector<std::uint8_t> flags(36, kLocked);
  flags[14] = flags[15] = 0;
  const CollapsePlan folded = plan(planner, mesh, flags);
  REQUIRE(meshes::merges(folded).size() == 1);
  CHECK(folded.collapses[0].target.isApprox(Eigen::Vector3d(2.05, 2, 0.05), 1e-9));
}

TEST_CASE("quadric placement moves a triangle's point by at most the radius of its circle") {
  // An obtuse triangle on a narrow top: its circle's radius is half the longest edge, which the third corner is
  // nearer to the middle than.
  IndexedMesh mesh =
      meshes::grid(6, [](std::uint32_t i, std::uint32_t) { return i < 3 ? 3 * (i - 2.0) : -3 * (i - 3.0); });
  for (auto& p : mesh.points) {
    if (p.x() > 2.5) p.x() -= 0.95;  // the top is 0.05 wide
    p.y() *= 0.04;
  }
  VertexDistance planner = folding(0.1);
  planner.placement = VertexDistance::Placement::quadric;
  planner.guard.min_cos = -1;
  std::vector<std::uint8_t> flags(36, kLocked);
  flags[14] = flags[15] = flags[21] = 0;  // 14 15 21: a right angle at 15
  mesh.points[15].y() += 0.01;            // and now more than that
  std::swap(mesh.triangles[0],
            *std::find(mesh.triangles.begin(), mesh.triangles.end(), IndexedMesh::Triangle{14, 15, 21}));
  const CollapsePlan folded = plan(planner, mesh, flags);
  REQUIRE(folded.collapses.size() == 2);
  const Eigen::Vector3d middle = (mesh.points[14] + mesh.points[21]) / 2;
  const double radius = (mesh.points[14] - mesh.points[21]).norm() / 2;
  CHECK((folded.collapses[1].target - middle).norm() == Approx(radius).epsilon(1e-9));
}

TEST_CASE("IVDD leaves a boundary edge's vertex in its middle with any placement") {
  const IndexedMesh roof =
      meshes::grid(4, [](std::uint32_t i, std::uint32_t j) { return i == 1 ? 0.5 : 0.1 * j; });
  VertexDistance planner = folding(9);
  planner.placement = VertexDistance::Placement::quadric;
  planner.boundary = Boundary::merge;
  planner.guard.min_cos = -1;
  std::vector<std::uint8_t> flags(16, kLocked);
  flags[1] = flags[2] = 0;
  const CollapsePlan folded = plan(planner, roof, flags);
  REQUIRE(folded.collapses.size() == 1);
  CHECK(folded.collapses[0].target == (roof.points[1] + roof.points[2]) / 2);
}
