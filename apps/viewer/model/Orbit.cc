#include "model/Orbit.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "whittle/surface/constants.hh"

namespace whittle::viewer {
namespace {

constexpr double kDegree = detail::kPi / 180;
const double kSlope = std::tan(render::ViewPoint().fov_degrees * kDegree / 2);  // of the picture's upper edge

}  // namespace

render::ViewPoint Orbit::view_point() const {
  render::ViewPoint from;
  from.toward_eye = rotation().row(2);
  from.up = rotation().row(1);
  return from;
}

Eigen::Matrix3d Orbit::rotation() const {
  const double y = yaw_ * kDegree, p = pitch_ * kDegree;
  Eigen::Matrix3d rows;
  rows.row(0) = Eigen::RowVector3d(std::cos(y), 0, -std::sin(y));
  rows.row(2) = Eigen::RowVector3d(std::sin(y) * std::cos(p), std::sin(p), std::cos(y) * std::cos(p));
  rows.row(1) = Eigen::Vector3d(rows.row(2)).cross(Eigen::Vector3d(rows.row(0)));
  if (up_ == Up::y) return rows;
  Eigen::Matrix3d stand;  // z upward, seen from -y
  stand << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return rows * stand;
}

void Orbit::frame(const Eigen::AlignedBox3d& box, double aspect) {
  const Eigen::Vector3d toward_eye = render::ViewPoint().toward_eye.normalized();
  yaw_ = std::atan2(toward_eye.x(), toward_eye.z()) / kDegree;
  pitch_ = std::asin(toward_eye.y()) / kDegree;
  fit(box, aspect);
}

void Orbit::fit(const Eigen::AlignedBox3d& box, double aspect) {
  render::ViewPoint from = view_point();
  from.margin = 0.06;
  const Eigen::Vector3d eye = -render::frame(box, box, aspect, from).view.topRightCorner<3, 1>();
  const Eigen::Matrix3d rows = rotation();
  const double depth = (rows * box.center()).z();
  target_ = rows.transpose() * Eigen::Vector3d(eye.x(), eye.y(), depth);
  distance_ = std::max(eye.z() - depth, 1e-12);
}

void Orbit::turn(double yaw_degrees, double pitch_degrees) {
  yaw_ = std::remainder(yaw_ + yaw_degrees, 360);
  pitch_ = std::clamp(pitch_ + pitch_degrees, -90.0, 90.0);
}

void Orbit::pan(double dx, double dy, double aspect) {
  const Eigen::Vector3d move(dx * aspect, dy, 0);
  target_ -= rotation().transpose() * (kSlope * distance_ * move);
}

void Orbit::zoom(double factor, double x, double y, double aspect) {
  const Eigen::Vector3d held(x * aspect, y, 0);  // in the plane through the target
  const double before = distance_;
  distance_ = std::max(distance_ * factor, 1e-12);
  target_ += rotation().transpose() * (kSlope * (before - distance_) * held);
}

render::Camera Orbit::camera(const Eigen::AlignedBox3d& scene, double aspect) const {
  render::Camera camera;
  const Eigen::Matrix3d rows = rotation();
  Eigen::Vector3d eye = rows * target_;
  eye.z() += distance_;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = scene.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    const double depth = eye.z() - (rows * corner).z();
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  farthest = std::max(1.01 * farthest, distance_);
  nearest = std::max(0.99 * nearest, 0.002 * farthest);
  if (nearest >= farthest) nearest = 0.5 * farthest;
  camera.view.topLeftCorner<3, 3>() = rows;
  camera.view.topRightCorner<3, 1>() = -eye;
  camera.projection.setZero();
  camera.projection(0, 0) = 1 / (kSlope * aspect);
  camera.projection(1, 1) = 1 / kSlope;
  camera.projection(2, 2) = -(farthest + nearest) / (farthest - nearest);
  camera.projection(2, 3) = -2 * farthest * nearest / (farthest - nearest);
  camera.projection(3, 2) = -1;
  return camera;
}

}  // namespace whittle::viewer
