#include "model/Orbit.hh"

#include "catch.hh"

using namespace whittle;
using namespace whittle::viewer;

namespace {

const Eigen::AlignedBox3d kBox{Eigen::Vector3d(10, 20, 30), Eigen::Vector3d(12, 21, 33)};

/// Where a point appears in the picture: -1 to 1.
Eigen::Vector3d seen(const Orbit& orbit, const Eigen::Vector3d& point, double aspect) {
  const render::Camera camera = orbit.camera(kBox, aspect);
  const Eigen::Vector4d clip = camera.projection * camera.view * point.homogeneous();
  return clip.head<3>() / clip.w();
}

bool whole_box_is_seen(const Orbit& orbit, double aspect) {
  for (int i = 0; i < 8; ++i) {
    const auto corner = kBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    if (seen(orbit, corner, aspect).cwiseAbs().maxCoeff() > 1) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a framed box is seen whole, from every side and in every shape of picture") {
  for (const double aspect : {0.3, 1.0, 2.5})
    for (const auto up : {Orbit::Up::y, Orbit::Up::z}) {
      Orbit orbit;
      orbit.set_up(up);
      orbit.frame(kBox, aspect);
      CHECK(whole_box_is_seen(orbit, aspect));
      orbit.turn(130, -70);
      orbit.fit(kBox, aspect);
      CHECK(whole_box_is_seen(orbit, aspect));
    }
}

TEST_CASE("the upward axis points upward") {
  Orbit orbit;
  orbit.frame(kBox, 1);
  const Eigen::Vector3d c = kBox.center();
  CHECK(seen(orbit, c + Eigen::Vector3d(0, 0.1, 0), 1).y() > seen(orbit, c, 1).y());
  CHECK(seen(orbit, c + Eigen::Vector3d(0.1, 0, 0), 1).x() > seen(orbit, c, 1).x());
  orbit.set_up(Orbit::Up::z);
  orbit.frame(kBox, 1);
  CHECK(seen(orbit, c + Eigen::Vector3d(0, 0, 0.1), 1).y() > seen(orbit, c, 1).y());
  CHECK(seen(orbit, c + Eigen::Vector3d(0.1, 0, 0), 1).x() > seen(orbit, c, 1).x());
}

TEST_CASE("zooming holds what lies under the cursor") {
  Orbit orbit;
  orbit.frame(kBox, 1.5);
  orbit.turn(30, 20);
  // The point in the plane through the target that is seen at (0.4, -0.3).
  const render::Camera camera = orbit.camera(kBox, 1.5);
  const Eigen::Matrix3d rows = camera.view.topLeftCorner<3, 3>();
  const double half = orbit.distance() / camera.projection(1, 1);
  const Eigen::Vector3d held =
      orbit.target() + rows.transpose() * Eigen::Vector3d(0.4 * half * 1.5, -0.3 * half, 0);
  CHECK(seen(orbit, held, 1.5).x() == Approx(0.4));
  const double before = orbit.distance();
  for (int i = 0; i < 5; ++i) orbit.zoom(0.8, 0.4, -0.3, 1.5);
  CHECK(orbit.distance() == Approx(before * std::pow(0.8, 5)));
  CHECK(seen(orbit, held, 1.5).x() == Approx(0.4));
  CHECK(seen(orbit, held, 1.5).y() == Approx(-0.3));
}

TEST_CASE("panning moves the model with the cursor") {
  Orbit orbit;
  orbit.frame(kBox, 2);
  const Eigen::Vector3d target = orbit.target();
  orbit.pan(0.25, -0.5, 2);
  CHECK(seen(orbit, target, 2).x() == Approx(0.25));
  CHECK(seen(orbit, target, 2).y() == Approx(-0.5));
}

TEST_CASE("the pitch stops at the poles") {
  Orbit orbit;
  orbit.turn(0, 500);
  CHECK(orbit.pitch() == 90);
  orbit.turn(0, -1000);
  CHECK(orbit.pitch() == -90);
}
