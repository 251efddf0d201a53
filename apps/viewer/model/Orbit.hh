/// \file
/// A camera that turns around a point.
#pragma once

#include <Eigen/Geometry>

#include "render/Camera.hh"

namespace whittle::viewer {

/// Turns like a globe on a stand: `yaw` about the model's upward axis, `pitch` about the picture's
/// horizontal. Places in the picture are x to the right and y upward, each from -1 to 1.
class Orbit {
 public:
  enum class Up { y, z };

  /// Sees the whole box, from the same side as the benchmark's pictures.
  void frame(const Eigen::AlignedBox3d& box, double aspect);
  /// Sees the whole box from where it looks now.
  void fit(const Eigen::AlignedBox3d& box, double aspect);

  void turn(double yaw_degrees, double pitch_degrees);
  /// Moves the model with the cursor.
  void pan(double dx, double dy, double aspect);
  /// What lies under the cursor stays there.
  /// \param factor  of the distance; below 1 goes nearer.
  void zoom(double factor, double x, double y, double aspect);

  /// \param scene  nothing of it is cut away.
  render::Camera camera(const Eigen::AlignedBox3d& scene, double aspect) const;

  void set_up(Up up) { up_ = up; }
  Up up() const { return up_; }
  double distance() const { return distance_; }
  const Eigen::Vector3d& target() const { return target_; }
  double yaw() const { return yaw_; }
  double pitch() const { return pitch_; }

  bool operator==(const Orbit& other) const {
    return target_ == other.target_ && distance_ == other.distance_ && yaw_ == other.yaw_ &&
           pitch_ == other.pitch_ && up_ == other.up_;
  }

 private:
  render::ViewPoint view_point() const;
  Eigen::Matrix3d rotation() const;  ///< rows: right, up, toward the eye

  Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
  double distance_ = 1, yaw_ = 0, pitch_ = 0;  // degrees
  Up up_ = Up::y;
};

}  // namespace whittle::viewer
