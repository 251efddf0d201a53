/// \file
/// Centres and quality of a triangle, and its closest point.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace whittle::detail {

/// Circumcentre: equally far from all three corners (Paper 1, III.I). For a degenerate triangle, which has
/// none, the midpoint of its longest edge.
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

/// A step from the start of a side of a triangle.
template <typename Real>
struct Step {
  Eigen::Matrix<Real, 3, 1> side;
  Real share;
};

/// Finds the point of a triangle that is nearest to `p`, by the corner, side or inside that this is in
/// (Ericson 2005, 5.1.5).
/// \return `visit(corner, step...)`: the point is the corner and none, one or two
/// steps from it. Where the triangle is degenerate to the last bit, a step may not be finite.
template <typename Real, typename Visit>
auto at_closest_point(const Eigen::Matrix<Real, 3, 1>& p, const Eigen::Matrix<Real, 3, 1>& a,
                      const Eigen::Matrix<Real, 3, 1>& b, const Eigen::Matrix<Real, 3, 1>& c, Visit visit) {
  using Vec = Eigen::Matrix<Real, 3, 1>;
  const Vec ab = b - a, ac = c - a, ap = p - a;
  const Real ab_a = ab.dot(ap), ac_a = ac.dot(ap);
  if (ab_a <= 0 && ac_a <= 0) return visit(a);
  const Vec bp = p - b;
  const Real ab_b = ab.dot(bp), ac_b = ac.dot(bp);
  if (ab_b >= 0 && ac_b <= ab_b) return visit(b);
  const Real of_c = ab_a * ac_b - ab_b * ac_a;             // barycentric, but for a common factor
  if (of_c <= 0 && ab_a >= 0 && ab_b <= 0 && ab_a > ab_b)  // not where a and b are one
    return visit(a, Step<Real>{ab, ab_a / (ab_a - ab_b)});
  const Vec cp = p - c;
  const Real ab_c = ab.dot(cp), ac_c = ac.dot(cp);
  if (ac_c >= 0 && ab_c <= ac_c) return visit(c);
  const Real of_b = ab_c * ac_a - ab_a * ac_c;
  if (of_b <= 0 && ac_a >= 0 && ac_c <= 0) return visit(a, Step<Real>{ac, ac_a / (ac_a - ac_c)});
  const Real of_a = ab_b * ac_c - ab_c * ac_b, to_c = ac_b - ab_b, to_b = ab_c - ac_c;
  if (of_a <= 0 && to_c >= 0 && to_b >= 0) return visit(b, Step<Real>{c - b, to_c / (to_c + to_b)});
  const Real all = of_a + of_b + of_c;
  return visit(a, Step<Real>{ab, of_b / all}, Step<Real>{ac, of_c / all});
}

template <typename Real>
Eigen::Matrix<Real, 3, 1> closest_point(const Eigen::Matrix<Real, 3, 1>& p,
                                        const Eigen::Matrix<Real, 3, 1>& a,
                                        const Eigen::Matrix<Real, 3, 1>& b,
                                        const Eigen::Matrix<Real, 3, 1>& c) {
  return at_closest_point(p, a, b, c, [](const auto& corner, const auto&... step) {
    Eigen::Matrix<Real, 3, 1> point = corner;
    ((point += step.share * step.side), ...);
    return point;
  });
}

/// Shares of a triangle's corners in a point of it; all that of the first where it has no area.
inline std::array<double, 3> shares(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return {1, 0, 0};
  const double of_b = (p - a).cross(c - a).dot(normal) / area;
  const double of_c = (b - a).cross(p - a).dot(normal) / area;
  const double inside_b = std::clamp(of_b, 0.0, 1.0), inside_c = std::clamp(of_c, 0.0, 1.0 - inside_b);
  return {1 - inside_b - inside_c, inside_b, inside_c};
}

/// The square of the distance; more accurate than from `closest_point`, whose coordinates are rounded.
template <typename Real>
Real squared_distance(const Eigen::Matrix<Real, 3, 1>& p, const Eigen::Matrix<Real, 3, 1>& a,
                      const Eigen::Matrix<Real, 3, 1>& b, const Eigen::Matrix<Real, 3, 1>& c) {
  return at_closest_point(p, a, b, c, [&](const auto& corner, const auto&... step) {
    Eigen::Matrix<Real, 3, 1> offset = p - corner;
    ((offset -= step.share * step.side), ...);
    return offset.squaredNorm();
  });
}

}  // namespace whittle::detail
