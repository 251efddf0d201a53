/// \file
/// Points and measures of a single triangle.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace whittle {

/// Circumcentre: equally far from all three corners (Paper 1, III.I). A degenerate triangle has none; then
/// the middle of its longest edge.
inline Eigen::Vector3d circumcenter(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                    const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, n = ab.cross(ac);
  Eigen::Vector3d center =
      a + (ac.squaredNorm() * n.cross(ab) + ab.squaredNorm() * ac.cross(n)) / (2 * n.squaredNorm());
  if (center.allFinite()) return center;
  const double la = (c - b).squaredNorm(), lb = ac.squaredNorm(), lc = ab.squaredNorm();
  return la >= lb && la >= lc ? (b + c) / 2 : lb >= lc ? (a + c) / 2 : (a + b) / 2;
}

/// Centre of the smallest circle that encloses the triangle: the circumcentre where the triangle is acute,
/// else the midpoint of the longest edge. Unlike the circumcentre it never leaves the triangle.
inline Eigen::Vector3d enclosing_center(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                        const Eigen::Vector3d& c) {
  if ((b - a).dot(c - a) <= 0) return (b + c) / 2;
  if ((a - b).dot(c - b) <= 0) return (a + c) / 2;
  if ((a - c).dot(b - c) <= 0) return (a + b) / 2;
  return circumcenter(a, b, c);
}

/// 4 sqrt(3) area / (sum of squared edges): 1 for an equilateral triangle, 0 for a degenerate one.
inline double triangle_quality(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares : 0;
}

}  // namespace whittle
