#include "whittle/plan/PlanDraft.hh"

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using meshes::IndexedMesh;
using Draft = PlanDraftT<double>;
using Verdict = Draft::Verdict;

namespace {

struct Bench {
  explicit Bench(IndexedMesh m, double min_cos = -1)
      : mesh(std::move(m)), surface(mesh), draft(surface, {min_cos}) {}
  Verdict edge(std::uint32_t to, std::uint32_t from) {
    return draft.merge({to, from}, (mesh.points[to] + mesh.points[from]) / 2);
  }
  IndexedMesh mesh;
  SurfaceT<double> surface;
  Draft draft;
};

}  // namespace

TEST_CASE("a legal collapse enters the plan with its place and its faces") {
  Bench bench(meshes::octahedron());
  REQUIRE(bench.edge(0, 1) == Verdict::accepted);
  CHECK(bench.draft.survivor(1) == 0);
  const CollapsePlan plan = bench.draft.take();
  REQUIRE(plan.collapses.size() == 1);
  CHECK(plan.collapses[0].from == 1);
  CHECK(plan.collapses[0].to == 0);
  CHECK(plan.collapses[0].faces == 2);
  CHECK(plan.collapses[0].target == Eigen::Vector3d(0.5, 0.5, 0));
  CHECK(plan.record.planned == 1);
  CHECK(plan.stages == std::vector<std::size_t>{0});
}

TEST_CASE("the link condition refuses a collapse that would break the manifold") {
  SECTION("a tetrahedron would become two faces back to back") {
    CHECK(Bench(meshes::tetrahedron()).edge(0, 1) == Verdict::refused_by_link);
  }
  SECTION("a common neighbour that bounds no face of the edge") {
    // A double pyramid over a triangle: its equator 0 1 2 is a loop of three edges without a face.
    IndexedMesh mesh;
    mesh.points = {{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
    CHECK(Bench(mesh).edge(0, 1) == Verdict::refused_by_link);
    CHECK(Bench(mesh).edge(0, 3) == Verdict::accepted);
  }
  SECTION("an inner edge between two boundary vertices would pinch the surface") {
    const IndexedMesh mesh = meshes::flat_grid(2);  // one square, its diagonal is an inner edge
    CHECK(Bench(mesh).edge(0, 3) == Verdict::refused_by_link);
  }
  SECTION("a boundary vertex does not leave the boundary, an inner one may go there") {
    const IndexedMesh mesh = meshes::cone(6, 0);
    CHECK(Bench(mesh).edge(0, 1) == Verdict::refused_by_link);
    CHECK(Bench(mesh).edge(1, 0) == Verdict::accepted);
  }
  SECTION("a boundary edge takes one face with it") {
    Bench bench(meshes::cone(6, 0));
    REQUIRE(bench.edge(1, 2) == Verdict::accepted);
    CHECK(bench.draft.take().collapses[0].faces == 1);
  }
  SECTION("a lone triangle") {
    IndexedMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    CHECK(Bench(mesh).edge(0, 1) == Verdict::refused_by_link);
  }
  SECTION("vertices that share no edge") {
    CHECK(Bench(meshes::octahedron()).edge(4, 5) == Verdict::refused_by_link);
  }
  SECTION("a complex vertex") {
    IndexedMesh mesh = meshes::cone(6, 0);
    mesh.points.emplace_back(0, 0, 1);
    mesh.triangles.push_back({0, 1, 7});
    CHECK(Bench(mesh).edge(1, 0) == Verdict::refused_by_link);
  }
}

TEST_CASE("the link condition is tested on the surface as the plan so far leaves it") {
  Bench bench(meshes::octahedron());
  REQUIRE(bench.edge(0, 1) == Verdict::accepted);
  // What is left is a double pyramid over the triangle 0 2 3, with the tips 4 and 5.
  CHECK(bench.edge(0, 2) == Verdict::refused_by_link);
  CHECK(bench.edge(4, 0) == Verdict::accepted);
  // What is left now is a tetrahedron.
  CHECK(bench.edge(4, 2) == Verdict::refused_by_link);
}

TEST_CASE("three vertices merge as a whole or not at all") {
  SECTION("as a whole") {
    Bench bench(meshes::torus(8, 6));
    const auto t = bench.mesh.triangles[0];
    REQUIRE(bench.draft.merge({t[0], t[1], t[2]}, bench.mesh.points[t[0]]) == Verdict::accepted);
    const CollapsePlan plan = bench.draft.take();
    CHECK(plan.collapses.size() == 2);
    CHECK(plan.record.planned == 1);
  }
  SECTION("not at all: the first collapse is legal, the second is not, and both are undone") {
    Bench bench(meshes::octahedron());
    REQUIRE(bench.draft.merge({0, 1, 4}, {0.3, 0.3, 0.3}) == Verdict::accepted);
    Bench again(meshes::octahedron());
    REQUIRE(again.edge(0, 1) == Verdict::accepted);
    REQUIRE(again.draft.merge({4, 0, 2}, {0, 0, 0.5}) == Verdict::refused_by_link);
    CHECK(again.draft.survivor(0) == 0);
    CHECK(again.draft.survivor(1) == 0);
    CHECK(again.edge(4, 0) == Verdict::accepted);
    CHECK(again.draft.survivor(1) == 4);
    CHECK(again.draft.take().collapses.size() == 2);
  }
}

TEST_CASE("the flip guard compares with the original normal") {
  // The tip of a flat cone moved outside of its polygon turns the faces on the far side over.
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.3, 0, 0}, {0.3, -0.1, 0}, {0.3, 0.1, 0}, 1);
  const Eigen::Vector3d outside(3, 0, 0), inside(0.1, 0, 0);
  CHECK(Bench(mesh, 0.2).draft.merge({0, 1, 2}, outside) == Verdict::refused_by_flip_guard);
  CHECK(Bench(mesh, 0.2).draft.merge({0, 1, 2}, inside) == Verdict::accepted);
  CHECK(Bench(mesh, -1).draft.merge({0, 1, 2}, outside) == Verdict::accepted);
}

TEST_CASE("the flip guard's cosine is a bound on the turn") {
  // Lifting the tip of a flat cone of n faces by h turns each face by atan(h / cos(pi / n)).
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.1, 0, 0}, {0.05, -0.05, 0}, {0.05, 0.05, 0}, 1);
  const double h = 2, cosine = 1 / std::sqrt(1 + h * h / (0.75));
  CHECK(Bench(mesh, cosine + 1e-9).draft.merge({0, 1, 2}, {0, 0, h}) == Verdict::refused_by_flip_guard);
  CHECK(Bench(mesh, cosine - 1e-9).draft.merge({0, 1, 2}, {0, 0, h}) == Verdict::accepted);
}

TEST_CASE("a face that would become degenerate is refused, one that was is not judged") {
  IndexedMesh mesh = meshes::cone(6, 0);
  CHECK(Bench(mesh, 0.2).draft.merge({1, 0}, mesh.points[1]) == Verdict::accepted);
  mesh.points[0] = mesh.points[4];  // two degenerate faces around the tip
  CHECK(Bench(mesh, 0.2).draft.merge({1, 0}, mesh.points[1]) == Verdict::accepted);
  mesh.points[2] = (mesh.points[1] + mesh.points[3]) / 2;  // 1 2 3 in a line
  mesh.points[0] = {0, 0, 0};
  CHECK(Bench(mesh, 0.2).draft.merge({1, 0}, mesh.points[1]) == Verdict::refused_by_flip_guard);
  CHECK(Bench(mesh, 0.2).draft.merge({2, 0}, mesh.points[2]) == Verdict::accepted);
}

TEST_CASE("the guard's cosine has a range") {
  CHECK_THROWS_AS((FlipGuard{1.0}.validate()), InvalidParameter);
  CHECK_THROWS_AS((FlipGuard{-1.5}.validate()), InvalidParameter);
  CHECK_THROWS_AS((FlipGuard{std::nan("")}.validate()), InvalidParameter);
  CHECK_NOTHROW((FlipGuard{-1.0}.validate()));
  CHECK_NOTHROW((FlipGuard{0.999}.validate()));
}

TEST_CASE("a collapse knows how many of its cluster follow") {
  const auto rest = [](const IndexedMesh& mesh, const std::vector<std::uint32_t>& members,
                       const Eigen::Vector3d& target) {
    Bench bench(mesh);
    REQUIRE(bench.draft.merge(members, target) == Verdict::accepted);
    std::vector<std::uint32_t> out;
    for (const Collapse& c : bench.draft.take().collapses) out.push_back(c.rest);
    return out;
  };
  using Rest = std::vector<std::uint32_t>;
  CHECK(rest(meshes::octahedron(), {0, 1}, {0.5, 0.5, 0}) == Rest{0});
  CHECK(rest(meshes::triangle_in_hexagon({0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, 1), {0, 1, 2}, {0.1, 0.1, 0}) ==
        Rest{1, 0});
  CHECK(rest(meshes::flat_grid(4), {5, 6, 10, 9}, {1, 1, 0}) == Rest{2, 1, 0});
}

TEST_CASE("a refused cluster leaves no collapse behind") {
  Bench bench(meshes::octahedron());
  REQUIRE(bench.edge(0, 1) == Verdict::accepted);
  REQUIRE(bench.draft.merge({4, 0, 2}, {0, 0, 0.5}) == Verdict::refused_by_link);
  const CollapsePlan plan = bench.draft.take();
  REQUIRE(plan.collapses.size() == 1);
  CHECK(plan.collapses[0].rest == 0);
  CHECK(plan.record.planned == 1);
}

TEST_CASE("the flip guard judges by reference normals where there are some") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.3, 0, 0}, {0.3, -0.1, 0}, {0.3, 0.1, 0}, 1);
  const Eigen::Vector3d target(0.1, 0, 0);
  const auto verdict = [&](const Eigen::Vector3d& normal, double min_cos) {
    const SurfaceT<double> surface(mesh, {{}, {}, std::vector<Eigen::Vector3d>(10, normal)});
    return Draft(surface, {min_cos}).merge({0, 1, 2}, target);
  };
  CHECK(verdict({0, 0, 1e-9}, 0.2) == Verdict::accepted);  // of any length
  CHECK(verdict({0, 0, -1}, 0.2) == Verdict::refused_by_flip_guard);
  CHECK(verdict({0, 0, -1}, -1) == Verdict::accepted);
  CHECK(verdict({0, 3, 4}, 0.8 - 1e-12) == Verdict::accepted);
  CHECK(verdict({0, 3, 4}, 0.8 + 1e-12) == Verdict::refused_by_flip_guard);
  CHECK(verdict({0, 0, 0}, 0.99) == Verdict::accepted);  // no normal, no verdict
}
