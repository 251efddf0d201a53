/// \file
/// Geometry of one triangle, in double precision.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/triangle.hh"

namespace whittle::measure {

/// The corners of a face.
struct Corners {
  Eigen::Vector3d a, b, c;

  /// Normal whose length is twice the area.
  Eigen::Vector3d normal() const { return (b - a).cross(c - a); }
  double area() const { return 0.5 * normal().norm(); }

  /// Area of at most 1e-12 of the longest edge squared: its normal is mostly rounding error. True for NaN.
  bool degenerate() const {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !(area() > 1e-12 * longest);
  }
};

inline Corners corners(const IndexedMesh& mesh, const IndexedMesh::Triangle& triangle) {
  return {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
}

/// The point of a triangle that is nearest to `p`.
inline Eigen::Vector3d closest_point(const Eigen::Vector3d& p, const Corners& t) {
  return whittle::detail::closest_point(p, t.a, t.b, t.c);
}

/// Shares of a triangle's corners in a point of it; all that of the first where it has no area.
inline std::array<double, 3> shares(const Corners& t, const Eigen::Vector3d& p) {
  return whittle::detail::shares(p, t.a, t.b, t.c);
}

}  // namespace whittle::measure
