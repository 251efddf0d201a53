#include "whittle/surface/EdgeChains.hh"

#include <vector>

#include "catch.hh"

using namespace whittle;
using detail::EdgeChains;

namespace {

constexpr std::uint32_t kNone = EdgeChains::kNone;

}  // namespace

TEST_CASE("two triangles that share an edge are a chain of its two sides") {
  const EdgeChains::Triangles triangles{{0, 1, 2}, {2, 1, 3}};
  const EdgeChains one(triangles, triangles, 4);
  REQUIRE(one.n_sides() == 6);
  CHECK(one.next(1) == 3);  // from 1 to 2, and from 2 to 1
  CHECK(one.agrees(1));
  for (const std::uint32_t side : {0u, 2u, 3u, 4u, 5u}) {
    CHECK(one.next(side) == kNone);
    CHECK_FALSE(one.agrees(side));
  }
  const EdgeChains at_low(triangles, {{0, 1, 2}, {2, 9, 3}}, 4);
  CHECK(at_low.next(1) == 3);
  CHECK_FALSE(at_low.agrees(1));
  const EdgeChains at_high(triangles, {{0, 1, 8}, {2, 1, 3}}, 4);  // the lesser wedge at 2 comes first
  CHECK(at_high.next(3) == 1);
  CHECK(at_high.next(1) == kNone);
  CHECK_FALSE(at_high.agrees(3));
}

TEST_CASE("an edge of four triangles is one chain, in which those with equal wedges follow one another") {
  const EdgeChains::Triangles triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {5, 0, 1}};
  const EdgeChains chains(triangles, {{7, 1, 2}, {1, 6, 3}, {6, 1, 4}, {5, 7, 1}}, 6);
  // At vertex 0 the wedges are 7, 6, 6 and 7.
  CHECK(chains.next(3) == 6);
  CHECK(chains.agrees(3));
  CHECK(chains.next(6) == 0);
  CHECK_FALSE(chains.agrees(6));
  CHECK(chains.next(0) == 10);
  CHECK(chains.agrees(0));
  CHECK(chains.next(10) == kNone);
}

TEST_CASE("chains are linked by hand, and empty ones have no side") {
  EdgeChains chains(2);
  CHECK(chains.next(5) == kNone);
  chains.link(5, 0, true);
  CHECK(chains.next(5) == 0);
  CHECK(chains.agrees(5));
  CHECK(EdgeChains().n_sides() == 0);
  CHECK(EdgeChains({}, {}, 0).n_sides() == 0);
}
