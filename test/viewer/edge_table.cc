#include "model/EdgeTable.hh"

#include <algorithm>

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::viewer;

namespace {

std::size_t count(const std::vector<Edge>& edges, EdgeSet set, double angle = 40) {
  return EdgeSets(edges).count(set, angle);
}

}  // namespace

TEST_CASE("a lone triangle has three boundary edges") {
  const auto edges = edge_table(meshes::lone_triangle());
  CHECK(edges.size() == 3);
  CHECK(count(edges, EdgeSet::boundary) == 3);
  CHECK(count(edges, EdgeSet::locked) == 0);
}

TEST_CASE("the edge table of an octahedron holds its dihedral angles") {
  const auto edges = edge_table(meshes::octahedron());
  CHECK(edges.size() == 12);
  for (const Edge& edge : edges) {
    CHECK(edge.kind == EdgeKind::plain);
    CHECK(edge.angle == Approx(70.5288).epsilon(1e-5));
    CHECK(edge.length == Approx(std::sqrt(2.0)));
    CHECK_FALSE(edge.held);
  }
  CHECK(count(edges, EdgeSet::feature, 70) == 12);
  CHECK(count(edges, EdgeSet::feature, 71) == 0);
}

TEST_CASE("an edge of three faces is not manifold, nor one whose faces disagree") {
  IndexedMesh book;
  book.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  book.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  CHECK(count(edge_table(book), EdgeSet::nonmanifold) == 1);
  CHECK(count(edge_table(book), EdgeSet::boundary) == 6);
  book.triangles = {{0, 1, 2}, {0, 1, 3}};
  CHECK(count(edge_table(book), EdgeSet::nonmanifold) == 1);
}

TEST_CASE("an inner edge between two boundary vertices is locked") {
  IndexedMesh square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto edges = edge_table(square);
  CHECK(count(edges, EdgeSet::boundary) == 4);
  REQUIRE(count(edges, EdgeSet::locked) == 1);
  CHECK(EdgeSets(edges).of(EdgeSet::locked).front() == EdgeSets::Ends{0, 2});
}

TEST_CASE("features stand in order: another angle is another count") {
  const auto edges = edge_table(meshes::torus(12, 8));
  const EdgeSets sets(edges);
  REQUIRE(sets.of(EdgeSet::feature).size() == edges.size());
  for (const double angle : {0.0, 20.0, 31.4, 40.0, 180.0}) {
    const auto sharp = [&](const Edge& edge) { return double(edge.angle) >= angle; };
    const std::size_t count = sets.count(EdgeSet::feature, angle);
    CHECK(count == static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), sharp)));
    for (std::size_t i = 0; i < count; ++i) {
      const auto found = std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) {
        return edge.ends == sets.of(EdgeSet::feature)[i];
      });
      CHECK(sharp(*found));
    }
  }
}
