#include "whittle/planners/Circumcenter.hh"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/plan/execute.hh"

using namespace whittle;
using Eigen::Vector3d;
using meshes::IndexedMesh;

namespace {

CollapsePlan plan(const Circumcenter& planner, const IndexedMesh& mesh,
                  std::vector<std::uint8_t> flags = {}) {
  return planner.plan(SurfaceT<double>(mesh, {std::move(flags), {}, {}}));
}

Circumcenter literal() {
  Circumcenter planner;
  planner.placement = Circumcenter::Placement::circumcenter;
  return planner;
}

Circumcenter unguarded(Circumcenter planner = {}) {
  planner.guard.min_cos = -1;
  return planner;
}

/// Corners whose circumcentre, (0, 1/16), is exact.
IndexedMesh exact() {
  return meshes::triangle_in_hexagon({-0.25, -0.125, 0}, {0.25, -0.125, 0}, {0, 0.375, 0}, 1);
}

}  // namespace

TEST_CASE("VT turns an acute triangle into its circumcentre") {
  const IndexedMesh mesh = exact();
  const CollapsePlan merged = plan(Circumcenter(), mesh);
  REQUIRE(meshes::merges(merged) == meshes::Merges{{1, 0}, {2, 0}});
  CHECK(merged.collapses[0].target == Vector3d(0, 0.0625, 0));
  CHECK(merged.collapses[1].target == Vector3d(0, 0.0625, 0));
  CHECK(merged.record.planned == 1);
  CHECK(merged.stages == std::vector<std::size_t>{0});

  const auto out = execute(merged, mesh);
  CHECK(out.mesh.points.size() == 7);
  CHECK(out.mesh.triangles.size() == 6);
  CHECK(out.mesh.points[0] == Vector3d(0, 0.0625, 0));
}

TEST_CASE("VT turns an obtuse triangle into the middle of its longest edge") {
  const CollapsePlan merged =
      plan(Circumcenter(), meshes::triangle_in_hexagon({-0.25, 0, 0}, {0.25, 0, 0}, {0.0625, 0.125, 0}, 1));
  REQUIRE(merged.collapses.size() == 2);
  CHECK(merged.collapses[1].target == Vector3d(0, 0, 0));
}

TEST_CASE("VT with the literal circumcentre leaves an obtuse triangle") {
  SECTION("a little, where the guard allows it") {
    const Vector3d a(-0.2, 0, 0), b(0.2, 0, 0), c(0, 0.15, 0);
    const CollapsePlan merged = plan(literal(), meshes::triangle_in_hexagon(a, b, c, 1));
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[1].target.isApprox(detail::circumcenter(a, b, c), 1e-15));
    CHECK(merged.collapses[1].target.y() < 0);
  }
  SECTION("too far for the guard, which skips the triangle") {
    const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.25, 0, 0}, {0.25, 0, 0}, {0, 0.015625, 0}, 1);
    const CollapsePlan refused = plan(literal(), mesh);
    CHECK(refused.collapses.empty());
    CHECK(refused.record.refused_by_flip_guard == 1);
    CHECK(refused.record.fell_back == 0);
    CHECK(plan(unguarded(literal()), mesh).collapses.size() == 2);
  }
}

TEST_CASE("VT needs three free vertices") {
  const IndexedMesh mesh = exact();
  for (const std::uint8_t flag : {kLocked, kFeature, kSeam, kComplex})
    for (int v = 0; v < 3; ++v) {
      std::vector<std::uint8_t> flags(9, 0);
      flags[v] = flag;
      CHECK(plan(unguarded(), mesh, flags).collapses.empty());
    }
  CHECK(plan(unguarded(), meshes::cone(6, 0)).collapses.empty());  // two of every three are on the boundary
}

TEST_CASE("VT keeps complex vertices") {
  IndexedMesh mesh = exact();
  mesh.points.emplace_back(0, 0, 1);
  mesh.triangles.push_back({0, 1, 9});  // a fin on the edge 0 1
  CHECK(plan(unguarded(), mesh).collapses.empty());
}

TEST_CASE("VT scans triangles in index order and merges a vertex once") {
  // Free are 5, 6, 9 and 10. The two triangles of the middle square share 5 and 10.
  IndexedMesh mesh = meshes::flat_grid(4);
  const CollapsePlan lower = plan(Circumcenter(), mesh);
  CHECK(meshes::merges(lower) == meshes::Merges{{6, 5}, {10, 5}});
  CHECK(lower.collapses[0].target == Vector3d(1.5, 1.5, 0));  // a right angle: the middle of the hypotenuse
  CHECK(lower.record.refused_by_flip_guard + lower.record.refused_by_link == 0);

  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  CHECK(meshes::merges(plan(Circumcenter(), mesh)) == meshes::Merges{{10, 5}, {9, 5}});
}

TEST_CASE("VT skips a refused triangle and goes on with its vertices") {
  IndexedMesh mesh = meshes::flat_grid(4);
  mesh.points[6] = {1.6, 1.4, 0};  // 5 6 10 becomes a needle; its neighbour 5 10 9 is right-angled
  const CollapsePlan merged = plan(literal(), mesh);
  REQUIRE(meshes::merges(merged) == meshes::Merges{{10, 5}, {9, 5}});
  CHECK(merged.collapses[0].target.isApprox(Vector3d(1.5, 1.5, 0), 1e-15));
  CHECK(merged.record.planned == 1);
  CHECK(merged.record.refused_by_flip_guard == 1);
}

TEST_CASE("VT counts what the link condition refuses") {
  SECTION("every triangle of a tetrahedron") {
    const CollapsePlan refused = plan(unguarded(), meshes::tetrahedron());
    CHECK(refused.collapses.empty());
    CHECK(refused.record.refused_by_link == 4);
  }
  SECTION("the far triangle of an octahedron, once the near one is a point") {
    const CollapsePlan merged = plan(unguarded(), meshes::octahedron());
    CHECK(meshes::merges(merged) == meshes::Merges{{1, 0}, {4, 0}});
    CHECK(merged.collapses[0].target.isApprox(Vector3d::Constant(1.0 / 3), 1e-15));
    CHECK(merged.record.refused_by_link == 1);
  }
}

TEST_CASE("VT keeps a vertex of tolerance 0 and has no other use for tolerances") {
  const IndexedMesh mesh = exact();
  std::vector<float> tolerance(9, 1);
  tolerance[2] = 0;
  CHECK(Circumcenter().plan(SurfaceT<double>(mesh, {{}, tolerance, {}})).collapses.empty());
  tolerance[2] = 1e-6f;
  CHECK(Circumcenter().plan(SurfaceT<double>(mesh, {{}, tolerance, {}})).collapses.size() == 2);
}

TEST_CASE("VT has no threshold to scale") {
  const IndexedMesh mesh = meshes::torus(12, 9);
  CHECK(meshes::merges(plan(literal().scaled(0), mesh)) == meshes::merges(plan(literal(), mesh)));
}

TEST_CASE("VT is not troubled by degenerate triangles") {
  SECTION("two corners in one place") {
    const CollapsePlan merged =
        plan(Circumcenter(), meshes::triangle_in_hexagon({-0.25, 0, 0}, {-0.25, 0, 0}, {0.25, 0, 0}, 1));
    for (const Collapse& c : merged.collapses) CHECK(c.target == Vector3d(0, 0, 0));
  }
  SECTION("three corners in one place") {
    const CollapsePlan merged =
        plan(Circumcenter(), meshes::triangle_in_hexagon({0.125, 0, 0}, {0.125, 0, 0}, {0.125, 0, 0}, 1));
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[1].target == Vector3d(0.125, 0, 0));
  }
  SECTION("a triangle that names a vertex twice") {
    IndexedMesh mesh = exact();
    mesh.triangles.push_back({2, 2, 0});
    CHECK(plan(Circumcenter(), mesh).collapses.empty());  // 0 and 2 are complex
  }
}

TEST_CASE("VT places no vertex at infinity, not even with the literal circumcentre and without the guard") {
  // A degenerate triangle has no circumcentre; the middle of its longest edge stands in for it.
  for (const Vector3d& c : {Vector3d(0.25, 0, 0), Vector3d(0, 0, 0)}) {
    const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.25, 0, 0}, {0.25, 0, 0}, c, 1);
    const CollapsePlan merged = plan(unguarded(literal()), mesh);
    REQUIRE(merged.collapses.size() == 2);
    CHECK(merged.collapses[1].target == Vector3d(0, 0, 0));
  }
}

TEST_CASE("VT leaves a mesh alone that has nothing to merge") {
  CHECK(plan(unguarded(), {}).collapses.empty());
  CHECK(plan(unguarded(), meshes::lone_triangle()).collapses.empty());
  CHECK(plan(unguarded(), meshes::isolated_points(3)).collapses.empty());
}

TEST_CASE("VT refuses a guard that means nothing") {
  for (const double cosine : {1.0, -1.5, std::nan("")}) {
    Circumcenter planner;
    planner.guard.min_cos = cosine;
    CHECK_THROWS_AS(planner.validate(), InvalidParameter);
    CHECK_THROWS_AS(plan(planner, exact()), InvalidParameter);
  }
}
