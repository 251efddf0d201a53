#include "whittle/surface/triangle.hh"

#include <tuple>

#include "catch.hh"

using namespace whittle::detail;
using Eigen::Vector3d;

TEST_CASE("the circumcentre is equally far from all corners") {
  const Vector3d a(0, 0, 0), b(4, 0, 0), c(1, 3, 2);
  const Vector3d m = circumcenter(a, b, c);
  CHECK((m - a).norm() == Approx((m - b).norm()));
  CHECK((m - a).norm() == Approx((m - c).norm()));
  CHECK((b - a).cross(c - a).dot(m - a) == Approx(0).margin(1e-12));
}

TEST_CASE("the centre of the enclosing circle") {
  SECTION("of an acute triangle is its circumcentre") {
    const Vector3d a(0, 0, 0), b(2, 0, 0), c(1, 2, 0);
    CHECK(enclosing_center(a, b, c).isApprox(Vector3d(1, 0.75, 0), 1e-15));
  }
  SECTION("of a right triangle is the middle of the hypotenuse") {
    CHECK(enclosing_center({0, 0, 0}, {2, 0, 0}, {0, 4, 0}) == Vector3d(1, 2, 0));
  }
  SECTION("of an obtuse triangle is the middle of its longest edge, at whichever corner the angle is") {
    const Vector3d a(0, 0, 0), b(10, 0, 0), c(5, 1, 0);
    CHECK(enclosing_center(a, b, c) == Vector3d(5, 0, 0));
    CHECK(enclosing_center(b, c, a) == Vector3d(5, 0, 0));
    CHECK(enclosing_center(c, a, b) == Vector3d(5, 0, 0));
    CHECK(circumcenter(a, b, c).y() == Approx(-12));
  }
  SECTION("of a degenerate triangle is the middle of its longest edge") {
    CHECK(enclosing_center({0, 0, 0}, {1, 0, 0}, {4, 0, 0}) == Vector3d(2, 0, 0));
    CHECK(enclosing_center({3, 3, 3}, {3, 3, 3}, {3, 3, 3}) == Vector3d(3, 3, 3));
  }
}

TEST_CASE("triangle quality is 1 for equilateral, 0 for degenerate, and knows no size") {
  CHECK(triangle_quality({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}) == Approx(1));
  CHECK(triangle_quality({0, 0, 0}, {1e-6, 0, 0}, {0.5e-6, 1e-6 * std::sqrt(0.75), 0}) == Approx(1));
  CHECK(triangle_quality({0, 0, 0}, {1, 0, 0}, {2, 0, 0}) == 0);
  CHECK(triangle_quality({1, 1, 1}, {1, 1, 1}, {1, 1, 1}) == 0);
  CHECK(triangle_quality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) == Approx(std::sqrt(3.0) / 2));
}

TEST_CASE("the distance to a triangle is that to its nearest corner, side or inside") {
  const Vector3d a(0, 0, 0), b(4, 0, 0), c(0, 3, 0);
  const auto square = [&](double x, double y, double z) {
    const Vector3d p(x, y, z);
    const double one = squared_distance(p, a, b, c);
    CHECK(squared_distance(p, b, c, a) == Approx(one));
    CHECK(squared_distance(p, c, b, a) == Approx(one));
    return one;
  };
  CHECK(square(1, 1, 2) == 4);
  CHECK(square(-3, -4, 0) == 25);
  CHECK(square(7, -4, 0) == 25);
  CHECK(square(-3, 7, 0) == 25);
  CHECK(square(2, -3, 4) == 25);
  CHECK(square(-3, 1, 4) == 25);
  CHECK(square(2 + 3, 1.5 + 4, 0) == Approx(25));  // straight out from the middle of the long side
  CHECK(square(1, 1, 0) == 0);
  CHECK_FALSE(squared_distance(Vector3d(5, 1, 0), a, a, a) < 25);  // no triangle at all
}

TEST_CASE("a triangle without a circumcentre has the middle of its longest edge, whichever that is") {
  const Vector3d p(0, 0, 0), q(3, 0, 0), r(1, 0, 0), middle(1.5, 0, 0);
  for (const auto& [a, b, c] :
       {std::tuple(p, q, r), std::tuple(q, r, p), std::tuple(r, p, q), std::tuple(q, p, r)})
    CHECK(circumcenter(a, b, c) == middle);
}
