/// \file
/// Where the eye is and what it sees, worked out from boxes.
#pragma once

#include <Eigen/Geometry>

namespace whittle::render {

/// From model coordinates to the eye's (`view`: a rigid motion, the eye looks down its negative z axis) and
/// from those to OpenGL's clip coordinates (`projection`).
struct Camera {
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
};

/// From which side to look, and with what lens.
struct ViewPoint {
  Eigen::Vector3d toward_eye = {0.10, 0.15, 1.0};  ///< from the model to the eye; any length, not along `up`
  Eigen::Vector3d up = {0.0, 1.0, 0.0};            ///< upward in the picture
  double fov_degrees = 25.0;                       ///< of the picture's height, in (0, 180)
  double margin = 0.02;  ///< of the picture's width and height, left free on each side
};

/// The camera that sees the whole of `subject` as large as the picture allows. Nothing of `scene` is cut away
/// in front of the eye or behind the subject unless it lies behind the eye.
/// \param aspect  the picture's width divided by its height.
Camera frame(const Eigen::AlignedBox3d& subject, const Eigen::AlignedBox3d& scene, double aspect,
             const ViewPoint& from = {});

/// A part of a box, its corners given as fractions of the box's sides: (0,0,0) to (1,1,1) is the whole.
Eigen::AlignedBox3d part_of(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& fractions);

}  // namespace whittle::render
