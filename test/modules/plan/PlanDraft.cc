#include "whittle/plan/PlanDraft.hh"

#include <algorithm>
#include <iterator>
#include <random>
#include <set>
#include <vector>

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

TEST_CASE("the flip guard judges each face by its own reference normal, and none that vanishes") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({0, 0, 0}, {0.2, 0, 0}, {0.1, 0.3, 0}, 1);
  for (std::size_t f = 0; f < 10; ++f) {
    std::vector<Eigen::Vector3d> normals(10, Eigen::Vector3d(0, 0, 1));
    normals[f] *= -1;
    const SurfaceT<double> surface(mesh, {{}, {}, normals});
    // The edge from 0 to 1 has the faces 0 and 3; 7 and 8 are at 2 alone.
    CHECK((Draft(surface, {0.2}).merge({0, 1}, {0.1, 0, 0}) == Verdict::accepted) ==
          (f == 0 || f == 3 || f == 7 || f == 8));
  }
}

TEST_CASE("the flip guard judges a target as the mesh will hold it") {
  whittle::IndexedMeshT<float> mesh;
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1)})
    mesh.points.emplace_back(float(x), float(y), 0.0f);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const SurfaceT<float> surface(mesh);
  const auto moved = [&](double x) { return PlanDraftT<float>(surface, {0.2}).merge({0}, {x, 0, 0}); };
  CHECK(moved(1 - 1e-6) == PlanDraftT<float>::Verdict::accepted);
  CHECK(moved(1 - 1e-9) == PlanDraftT<float>::Verdict::refused_by_flip_guard);  // 1 in float: no area is left
}

TEST_CASE("three faces around an inner vertex become one at the boundary, and in a closed surface, too") {
  Bench at_boundary(meshes::cone(3, 0));
  CHECK(at_boundary.edge(1, 0) == Verdict::accepted);
  IndexedMesh tipped = meshes::octahedron();
  tipped.points.emplace_back(0.4, 0.4, 0.4);
  tipped.triangles[0] = {0, 1, 6};
  tipped.triangles.push_back({1, 4, 6});
  tipped.triangles.push_back({4, 0, 6});
  CHECK(Bench(tipped).edge(0, 6) == Verdict::accepted);
  CHECK(Bench(tipped).edge(6, 0) == Verdict::accepted);
}

TEST_CASE("an ear may fold along the boundary, and faces around what stays are not judged") {
  Bench strip(meshes::strip(3, 1));
  CHECK(strip.edge(0, 3) == Verdict::accepted);  // 3 has one face
  // Faces of 1 that do not touch 0 are turned over already.
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.3, 0, 0}, {0.3, -0.1, 0}, {0.3, 0.1, 0}, 1);
  std::vector<Eigen::Vector3d> normals(10, Eigen::Vector3d::UnitZ());
  std::size_t turned = 0;
  for (std::size_t f = 0; f < 10; ++f) {
    const auto& t = mesh.triangles[f];
    const auto has = [&](std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
    if (!has(1) || has(0)) continue;
    normals[f] *= -1;
    ++turned;
  }
  REQUIRE(turned > 0);
  const SurfaceT<double> surface(mesh, {{}, {}, normals});
  CHECK(Draft(surface, {0.2}).merge({1, 0}, mesh.points[1]) == Verdict::accepted);
  CHECK(Draft(surface, {0.2}).merge({1, 0}, mesh.points[0]) == Verdict::refused_by_flip_guard);
}

namespace {

/// Merges ring vertices of a bipyramid with `n` of them into its tip 0 as often as that is legal.
std::size_t merges_into_tip(std::uint32_t n) {
  IndexedMesh mesh = meshes::cone(static_cast<int>(n), 1);  // and a second tip, n + 1
  mesh.points.emplace_back(0, 0, -1);
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({n + 1, (i + 1) % n + 1, i + 1});
  Bench bench(mesh);
  std::size_t count = 0;
  for (std::uint32_t v = 1; v <= n; ++v) count += bench.edge(0, v) == Verdict::accepted;
  return count;
}

}  // namespace

TEST_CASE("the link condition is the same at a vertex of very many faces") {
  // The rim goes into the tip one after the other, until a tetrahedron is left.
  for (const std::uint32_t n : {5u, 63u, 64u, 65u, 300u}) CHECK(merges_into_tip(n) == n - 2);
  for (const std::uint32_t n : {5u, 63u, 64u, 65u, 300u}) {
    // Along the rim of a fan one after the other goes, as long as three are left. None leaves the boundary.
    Bench bench(meshes::cone(static_cast<int>(n), 0));
    CHECK(bench.edge(0, 1) == Verdict::refused_by_link);
    std::size_t count = 0;
    for (std::uint32_t v = n; v-- > 1;) count += bench.edge(n, v) == Verdict::accepted;
    CHECK(count == n - 3);
  }
}

TEST_CASE("clusters of any size answer the link condition as a brute search does") {
  // Hubs that share a rim, with the rim merged in an order that makes clusters grow and refuses many.
  for (const std::uint32_t n : {30u, 90u}) {
    IndexedMesh mesh = meshes::cone(static_cast<int>(n), 1);
    mesh.points.emplace_back(0, 0, -1);
    for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({n + 1, (i + 1) % n + 1, i + 1});
    Bench bench(mesh);
    std::mt19937 random(n);
    std::size_t accepted = 0;
    for (int round = 0; round < 400; ++round) {
      const auto& edge = mesh.triangles[random() % mesh.triangles.size()];
      const std::uint32_t a = bench.draft.survivor(edge[0]), b = bench.draft.survivor(edge[1 + random() % 2]);
      if (a == b) continue;
      std::vector<std::set<std::uint32_t>> rings(n + 2);
      std::size_t shared = 0;
      for (const auto& t : mesh.triangles) {
        std::set<std::uint32_t> s;
        for (const std::uint32_t v : t) s.insert(bench.draft.survivor(v));
        if (s.size() < 2) continue;
        for (const std::uint32_t v : s)
          for (const std::uint32_t w : s)
            if (v != w) rings[v].insert(w);
        shared += s.size() == 3 && s.count(a) + s.count(b) == 2;
      }
      std::vector<std::uint32_t> common;
      std::set_intersection(rings[a].begin(), rings[a].end(), rings[b].begin(), rings[b].end(),
                            std::back_inserter(common));
      const bool legal = shared == 2 && common.size() == 2 && !(rings[a].size() == 3 && rings[b].size() == 3);
      REQUIRE((bench.draft.merge({a, b}, mesh.points[a]) == Verdict::accepted) == legal);
      accepted += legal;
    }
    CHECK(accepted > 4);
  }
}

TEST_CASE("hubs that a refused cluster would have joined are no neighbours after it") {
  // The tips 0 and 101 over one rim. When 1 has merged into 0, the tips are neighbours, and 50 may not.
  IndexedMesh mesh = meshes::cone(100, 1);
  mesh.points.emplace_back(0, 0, -1);
  for (std::uint32_t i = 0; i < 100; ++i) mesh.triangles.push_back({101, (i + 1) % 100 + 1, i + 1});
  Bench bench(mesh);
  REQUIRE(bench.draft.merge({0, 1, 50}, mesh.points[0]) == Verdict::refused_by_link);
  CHECK(bench.draft.merge({0, 50}, mesh.points[0]) == Verdict::accepted);
  CHECK(bench.draft.merge({0, 1}, mesh.points[0]) == Verdict::refused_by_link);
}

TEST_CASE("the flip guard looks at every face of a vertex of very many, again and again") {
  for (const int n : {60, 70, 200}) {
    const IndexedMesh mesh = meshes::cone(n, 0);
    Bench bench(mesh, 0.2);
    for (int i = 0; i < n; ++i) {  // out over each face of the rim
      const Eigen::Vector3d out = mesh.points[1 + static_cast<std::size_t>(i)] +
                                  mesh.points[1 + static_cast<std::size_t>((i + 1) % n)];
      REQUIRE(bench.draft.merge({0}, out) == Verdict::refused_by_flip_guard);
    }
    CHECK(bench.draft.merge({0}, {0.1, 0.2, 0}) == Verdict::accepted);
  }
}
