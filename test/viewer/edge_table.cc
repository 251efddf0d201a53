#include "model/EdgeTable.hh"

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::viewer;

namespace {

std::size_t count(const std::vector<Edge>& edges, EdgeSet set, double angle = 40) {
  return select(edges, set, angle).size();
}

}  // namespace

TEST_CASE("a lone triangle has three boundary edges") {
  const auto edges = edge_table(meshes::lone_triangle());
  CHECK(edges.size() == 3);
  CHECK(count(edges, EdgeSet::boundary) == 3);
  CHECK(count(edges, EdgeSet::locked) == 0);
}

TEST_CASE("the angles of an octahedron") {
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
  CHECK(select(edges, EdgeSet::locked, 40).front() == std::array<std::uint32_t, 2>{0, 2});
}
