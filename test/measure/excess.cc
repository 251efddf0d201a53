#include "measure/Excess.hh"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/surface/errors.hh"

using namespace whittle;
using namespace whittle::measure;

TEST_CASE("the excess and the distance look at the same points") {
  const IndexedMesh a = torus(40, 20), b = torus(30, 16);
  const DistanceOptions quick{20000, 2};
  const double max = distance(a, b, quick).two_sided.max;
  CHECK(excess(a, b, 0, quick).max == max);
  CHECK(excess(a, b, max, quick).none());
  const Excess below = excess(a, b, 0.99 * max, quick);
  CHECK_FALSE(below.none());
  CHECK(below.original.size() + below.simplified.size() < a.points.size() / 2);
}

TEST_CASE("the excess names the vertices of the faces that lie too far") {
  IndexedMesh before = square(0, 0), after = before;
  const auto spike = static_cast<std::uint32_t>(after.points.size());
  // A face of its own, half a unit above the square.
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, .5), Eigen::Vector3d(1, 0, .5), Eigen::Vector3d(0, 1, .5)})
    after.points.push_back(p);
  after.triangles.push_back({spike, spike + 1, spike + 2});
  const Excess found = excess(before, after, 0.4);
  CHECK(found.original.empty());
  REQUIRE(found.simplified.size() == 3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    CHECK(found.simplified[i].vertex == spike + i);
    CHECK(found.simplified[i].distance == 0.5);
  }
  CHECK(found.max == 0.5);
  CHECK(excess(before, after, 0.5).none());
}

TEST_CASE("the excess refuses parameters out of range") {
  CHECK_THROWS_AS(excess(square(0, 0), square(0, 0), -1), InvalidParameter);
  CHECK_THROWS_AS(excess(square(0, 0), IndexedMesh(), 1), InvalidMesh);
}
