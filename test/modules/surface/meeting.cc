#include "whittle/surface/meeting.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "catch.hh"

using namespace whittle::detail;
using Eigen::Vector3d;
using Face = std::array<std::uint32_t, 3>;

namespace {

/// Whether two faces intersect, whichever comes first, wherever they begin and whichever way they turn.
bool intersect(const std::vector<Vector3d>& points, Face f, Face g) {
  const auto place = [&](std::uint32_t v) { return points[v]; };
  const bool first = faces_intersect(f, g, place);
  const auto check_all = [&](const Face& face, const Face& other) {
    Face turned = face;
    std::sort(turned.begin(), turned.end());
    do {
      CHECK(faces_intersect(turned, other, place) == first);
      CHECK(faces_intersect(other, turned, place) == first);
    } while (std::next_permutation(turned.begin(), turned.end()));
  };
  check_all(f, g);
  check_all(g, f);
  return first;
}

/// Two triangles without a common vertex, also seen along the other axes and from far away.
bool meet(const Corners3& s, const Corners3& t, bool from_far = true) {
  std::vector<Vector3d> points(s.begin(), s.end());
  points.insert(points.end(), t.begin(), t.end());
  const bool first = intersect(points, {0, 1, 2}, {3, 4, 5});
  for (int axis = 0; axis < 2; ++axis) {
    for (Vector3d& p : points) p = Vector3d(p.y(), p.z(), p.x());
    CHECK(intersect(points, {0, 1, 2}, {3, 4, 5}) == first);
  }
  if (!from_far) return first;  // which would round
  for (Vector3d& p : points) p = 0x1p40 * p + Vector3d(0x1p60, -0x1p70, 0x1p50);
  CHECK(intersect(points, {0, 1, 2}, {3, 4, 5}) == first);
  return first;
}

const Corners3 kFloor{Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};

}  // namespace

TEST_CASE("faces that share no vertex meet where they have a point in common") {
  SECTION("one goes through the other") {
    CHECK(meet(kFloor, {Vector3d(1, 1, -1), Vector3d(1, 1, 1), Vector3d(9, 9, 0)}));
    CHECK(meet(kFloor, {Vector3d(1, 1, -1), Vector3d(2, 1, -1), Vector3d(1, 1, 5)}));
  }
  SECTION("they pass each other") {
    CHECK_FALSE(meet(kFloor, {Vector3d(3, 3, -1), Vector3d(3, 3, 1), Vector3d(9, 9, 0)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(1, 1, 1), Vector3d(2, 1, 1), Vector3d(1, 2, 3)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(-1, -1, 1), Vector3d(-1, -1, -1), Vector3d(-2, 5, 0)}));
  }
  SECTION("a corner touches the inside, an edge, a corner") {
    CHECK(meet(kFloor, {Vector3d(1, 1, 0), Vector3d(1, 2, 3), Vector3d(2, 1, 3)}));
    CHECK(meet(kFloor, {Vector3d(2, 2, 0), Vector3d(5, 5, 1), Vector3d(5, 5, -1)}));
    CHECK(meet(kFloor, {Vector3d(4, 0, 0), Vector3d(5, 1, 1), Vector3d(5, 1, -1)}));
    CHECK_FALSE(
        meet(kFloor, {Vector3d(std::nextafter(4, 5), 0, 0), Vector3d(5, 1, 1), Vector3d(5, 1, -1)}, false));
    CHECK_FALSE(meet(kFloor, {Vector3d(1, 1, 0x1p-1000), Vector3d(1, 2, 3), Vector3d(2, 1, 3)}, false));
  }
  SECTION("edges cross or touch") {
    CHECK(meet(kFloor, {Vector3d(2, 0, -1), Vector3d(2, 0, 1), Vector3d(2, -4, 0)}));
    CHECK(meet(kFloor,
               {Vector3d(1, -1, 0), Vector3d(1, 1, 0), Vector3d(1, -1, 2)}));  // in its plane, from outside
    CHECK(meet(kFloor, {Vector3d(1, 1, 0), Vector3d(2, 1, 0), Vector3d(1, 1, 2)}));  // in its plane, inside
    CHECK(meet(kFloor,
               {Vector3d(-1, 1, 0), Vector3d(9, 1, 0), Vector3d(3, 1, 2)}));  // in its plane, right across
    CHECK(meet(kFloor, {Vector3d(3, 0, 0), Vector3d(9, 0, 0), Vector3d(5, 0, 2)}));  // along its edge
    CHECK(meet(kFloor,
               {Vector3d(4, 0, 0), Vector3d(9, 0, 0), Vector3d(5, 0, 2)}));  // in line with it, from its end
    CHECK_FALSE(meet(kFloor, {Vector3d(5, 0, 0), Vector3d(9, 0, 0), Vector3d(5, 0, 2)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(1, -2, 0), Vector3d(1, -1, 0), Vector3d(1, -1, 2)}));
  }
  SECTION("in one plane") {
    CHECK(meet(kFloor, {Vector3d(1, 1, 0), Vector3d(2, 1, 0), Vector3d(1, 2, 0)}));        // inside
    CHECK(meet(kFloor, {Vector3d(-9, -9, 0), Vector3d(30, -9, 0), Vector3d(-9, 30, 0)}));  // around
    CHECK(meet(kFloor, {Vector3d(3, 3, 0), Vector3d(-1, 3, 0), Vector3d(3, -1, 0)}));      // a star
    CHECK(meet(kFloor, {Vector3d(2, 2, 0), Vector3d(5, 3, 0), Vector3d(3, 5, 0)}));   // a corner on an edge
    CHECK(meet(kFloor, {Vector3d(4, 0, 0), Vector3d(5, 0, 0), Vector3d(5, 1, 0)}));   // corner to corner
    CHECK(meet(kFloor, {Vector3d(1, 0, 0), Vector3d(3, 0, 0), Vector3d(2, -1, 0)}));  // along an edge
    CHECK(meet(kFloor, kFloor));
    CHECK_FALSE(meet(kFloor, {Vector3d(3, 2, 0), Vector3d(5, 3, 0), Vector3d(3, 5, 0)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(5, 0, 0), Vector3d(6, 0, 0), Vector3d(5, 1, 0)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(1, 1, 1), Vector3d(2, 1, 1), Vector3d(1, 2, 1)}));  // parallel
  }
  SECTION("a face without area meets nothing") {
    CHECK_FALSE(meet(kFloor, {Vector3d(1, 1, -1), Vector3d(1, 1, 0), Vector3d(1, 1, 1)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(1, 1, 0), Vector3d(2, 1, 0), Vector3d(3, 1, 0)}));
    CHECK_FALSE(meet(kFloor, {Vector3d(1, 1, 0), Vector3d(1, 1, 0), Vector3d(1, 1, 0)}));
    CHECK_FALSE(meet({Vector3d(1, 1, 0), Vector3d(2, 1, 0), Vector3d(3, 1, 0)},
                     {Vector3d(2, 1, 0), Vector3d(1, 1, 0), Vector3d(5, 1, 0)}));
  }
}

TEST_CASE("faces that share a vertex intersect where they meet beyond it") {
  // 0 is shared; the first face is 0 1 2.
  const auto beyond = [](const Vector3d& c, const Vector3d& d) {
    return intersect({Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0), c, d}, {0, 1, 2}, {0, 3, 4});
  };
  CHECK(beyond({1, 1, 1}, {1, 1, -1}));                // through its inside
  CHECK(beyond({9, 9, 1}, {9, 9, -1}));                // through it and its opposite edge
  CHECK(beyond({1, 1, 0}, {1, 1, 1}));                 // an edge in it
  CHECK(beyond({9, 0, 0}, {1, 1, 1}));                 // an edge along its edge
  CHECK(beyond({1, 0, 1}, {1, 0, -1}));                // its edge in the other
  CHECK_FALSE(beyond({-1, 1, 1}, {-1, 1, -1}));        // only at the vertex, on both sides of the plane
  CHECK_FALSE(beyond({1, 1, 1}, {2, 2, 1}));           // on one side
  CHECK_FALSE(beyond({-1, 0, 0}, {-1, 0, 1}));         // an edge in line with its edge, the other way
  CHECK_FALSE(beyond({-1, 0x1p-300, 0}, {0, -1, 0}));  // in its plane, beside it
  CHECK(beyond({1, 1, 0}, {-1, 3, 0}));                // in its plane, over it
  CHECK(beyond({1, 0, 0}, {1, -1, 0}));                // along its edge
  CHECK(beyond({9, 1, 0}, {1, 9, 0}));                 // around its sector
  CHECK(beyond({1, 2, 0}, {2, 1, 0}));                 // within it
  CHECK_FALSE(beyond({-1, 0, 0}, {0, -1, 0}));         // opposite
  CHECK_FALSE(beyond({1, 1, 0}, {2, 2, 0}));           // without area
  CHECK_FALSE(beyond({0, 0, 0}, {1, 1, 1}));
}

TEST_CASE("faces that share an edge intersect where they overlap") {
  const auto over = [](const Vector3d& d) {
    return intersect({Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0), d}, {0, 1, 2}, {0, 1, 3});
  };
  CHECK(over({1, 1, 0}));
  CHECK(over({-5, 9, 0}));
  CHECK(over({0, 4, 0}));  // another vertex at the same place
  CHECK_FALSE(over({1, -1, 0}));
  CHECK_FALSE(over({1, 1, 0x1p-1000}));
  CHECK_FALSE(over({1, 1, -1}));
  CHECK_FALSE(over({2, 0, 0}));  // without area
  CHECK_FALSE(over({9, 0, 0}));
}

TEST_CASE("faces on the same vertices intersect, unless they have no area") {
  CHECK(intersect({kFloor[0], kFloor[1], kFloor[2]}, {0, 1, 2}, {0, 2, 1}));
  CHECK_FALSE(intersect({Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(3, 3, 3)}, {0, 1, 2}, {0, 2, 1}));
  const auto place = [](std::uint32_t v) { return kFloor[v % 3]; };
  CHECK_FALSE(faces_intersect({0, 1, 1}, {0, 1, 2}, place));
  CHECK_FALSE(faces_intersect({0, 1, 2}, {2, 2, 0}, place));
}

TEST_CASE("on a small lattice the answer does not depend on order, axis or place") {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(0, 3);
  const auto point = [&] { return Vector3d(coordinate(random), coordinate(random), coordinate(random)); };
  std::size_t met = 0, beyond = 0, overlap = 0;
  for (int i = 0; i < 60; ++i) {
    met += meet({point(), point(), point()}, {point(), point(), point()});
    beyond += intersect({point(), point(), point(), point(), point()}, {0, 1, 2}, {0, 3, 4});
    overlap += intersect({point(), point(), point(), point()}, {0, 1, 2}, {0, 1, 3});
  }
  CHECK((met > 5 && met < 55));
  CHECK((beyond > 5 && beyond < 55));
  CHECK((overlap > 0 && overlap < 30));
}
