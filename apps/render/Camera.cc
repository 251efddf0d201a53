#include "render/Camera.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "whittle/surface/constants.hh"

namespace whittle::render {
namespace {

Eigen::Vector3d corner(const Eigen::AlignedBox3d& box, int number) {
  return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(number));
}

/// Rows: the picture's right, its up, and toward the eye.
Eigen::Matrix3d axes(const ViewPoint& from) {
  Eigen::Matrix3d rows;
  rows.row(2) = from.toward_eye.normalized();
  rows.row(0) = from.up.cross(from.toward_eye).normalized();
  rows.row(1) = rows.row(2).cross(rows.row(0));
  return rows;
}

/// The nearest place of the eye from which two slanted planes of slope `slope` enclose all corners: where it
/// lies across, and along the line of sight.
struct Fit {
  double across, along;
};

Fit fit(const Eigen::AlignedBox3d& box, const Eigen::Matrix3d& rotation, int axis, double slope) {
  double right = -std::numeric_limits<double>::infinity(), left = right;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d p = rotation * corner(box, i);
    right = std::max(right, p[axis] + slope * p.z());
    left = std::max(left, -p[axis] + slope * p.z());
  }
  return {(right - left) / 2, (right + left) / (2 * slope)};
}

Eigen::Matrix4d perspective(double slope_x, double slope_y, double near, double far) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = 1 / slope_x;
  m(1, 1) = 1 / slope_y;
  m(2, 2) = -(far + near) / (far - near);
  m(2, 3) = -2 * far * near / (far - near);
  m(3, 2) = -1;
  return m;
}

}  // namespace

Camera frame(const Eigen::AlignedBox3d& subject, const Eigen::AlignedBox3d& scene, double aspect,
             const ViewPoint& from) {
  const Eigen::Matrix3d rotation = axes(from);
  const double slope_y = std::tan(from.fov_degrees * detail::kPi / 360);
  const double slope_x = slope_y * aspect;
  const double used = 1 - 2 * from.margin;
  const Fit horizontal = fit(subject, rotation, 0, used * slope_x);
  const Fit vertical = fit(subject, rotation, 1, used * slope_y);
  const Eigen::Vector3d eye(horizontal.across, vertical.across, std::max(horizontal.along, vertical.along));

  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (int i = 0; i < 8; ++i) {
    const double depth = eye.z() - (rotation * corner(scene, i)).z();
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // A little slack against rounding, and a near plane that leaves the depth buffer useful digits.
  farthest *= 1.01;
  nearest = std::max(0.99 * nearest, 0.01 * farthest);

  Camera camera;
  camera.view.topLeftCorner<3, 3>() = rotation;
  camera.view.topRightCorner<3, 1>() = -eye;
  camera.projection = perspective(slope_x, slope_y, nearest, farthest);
  return camera;
}

Eigen::AlignedBox3d part_of(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& fractions) {
  return {box.min() + fractions.min().cwiseProduct(box.sizes()),
          box.min() + fractions.max().cwiseProduct(box.sizes())};
}

}  // namespace whittle::render
