/// \file
/// On which side a point lies, decided exactly.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "whittle/surface/ExactSum.hh"

/// The sign is first sought in plain doubles, with a bound on what rounding can do to it, and where that does not tell
/// computed without rounding.
///
/// Exact for all floats, and for doubles whose magnitudes, where they are not 0, differ by a factor of less than 2^600 on each
/// axis. What is less than that share of the greatest loses bits, or counts as 0. Coordinates must be finite.
namespace whittle::detail {

inline int sign_of(double x) {
  return (x > 0) - (x < 0);
}

namespace orienting {

/// Where the bounds on rounding hold and nothing overflows or gets lost: 0, or the greatest difference on an axis.
constexpr double kLeast = 0x1p-320, kGreatest = 0x1p+330;
/// Where products of three coordinates are exact.
constexpr double kLeastExact = 0x1p-300;

/// A power of two by which the coordinates of an axis must be multiplied for the products to be exact.
template <std::size_t n>
double exact_scale(const std::array<double, n>& coordinates) {
  double least = HUGE_VAL, greatest = 0;
  for (const double x : coordinates) {
    if (x != 0) least = std::min(least, std::abs(x));
    greatest = std::max(greatest, std::abs(x));
  }
  if (greatest == 0 || (least >= kLeastExact && greatest <= kGreatest)) return 1;
  // The greatest comes close to kGreatest; the factor itself must be a double.
  return std::ldexp(1.0, std::min(329 - std::ilogb(greatest), 1023));
}

using Difference = ExactSum<2>;

/// The differences of some coordinates from the last of them.
template <std::size_t n>
std::array<Difference, n - 1> differences(std::array<double, n> coordinates) {
  if (const double scale = exact_scale(coordinates); scale != 1)
    for (double& x : coordinates) x *= scale;
  std::array<Difference, n - 1> out;
  for (std::size_t i = 0; i + 1 < n; ++i) out[i] = Difference::difference(coordinates[i], coordinates[n - 1]);
  return out;
}

inline int exact_orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                          const Eigen::Vector3d& d) {
  const auto x = differences<4>({b.x(), c.x(), d.x(), a.x()}),
             y = differences<4>({b.y(), c.y(), d.y(), a.y()}),
             z = differences<4>({b.z(), c.z(), d.z(), a.z()});
  ExactSum<192> determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    ExactSum<16> minor;
    minor.add_product(x[i], y[j]);
    minor.add_product(x[j], y[i], -1);
    determinant.add_product(minor, z[k]);
  }
  return determinant.sign();
}

inline int exact_orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const auto x = differences<3>({b.x(), c.x(), a.x()}), y = differences<3>({b.y(), c.y(), a.y()});
  ExactSum<16> determinant;
  determinant.add_product(x[0], y[1]);
  determinant.add_product(x[1], y[0], -1);
  return determinant.sign();
}

}  // namespace orienting

/// \return 1 if d lies on the side of the plane abc to which its normal (b - a) x (c - a) points, -1 if it lies on the other,
/// 0 if it lies in the plane or there is none, as a, b and c lie on a line.
inline int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& d) {
  using namespace orienting;
  const Eigen::Vector3d u = b - a, v = c - a, w = d - a;
  const Eigen::Vector3d most = u.cwiseAbs().cwiseMax(v.cwiseAbs()).cwiseMax(w.cwiseAbs());
  const double determinant = w.x() * (u.y() * v.z() - u.z() * v.y()) +
                             w.y() * (u.z() * v.x() - u.x() * v.z()) +
                             w.z() * (u.x() * v.y() - u.y() * v.x());
  // Six products of at most `most` each, through at most eight roundings of 2^-53 each: 48 of them, and some for the bound.
  constexpr double kRounding = 0x1p-47;
  if (most.minCoeff() >= kLeast && most.maxCoeff() <= kGreatest) {
    if (std::abs(determinant) > kRounding * (most.x() * most.y() * most.z())) return sign_of(determinant);
  } else if (most.minCoeff() == 0) {
    return 0;  // a difference is 0 only if it is exactly 0
  }
  return exact_orient3d(a, b, c, d);
}

/// \return 1 if the turn from a over b to c is counter-clockwise, -1 if it is clockwise, 0 if they lie on a line.
inline int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  using namespace orienting;
  const Eigen::Vector2d u = b - a, v = c - a, most = u.cwiseAbs().cwiseMax(v.cwiseAbs());
  const double left = u.x() * v.y(), right = u.y() * v.x();
  // Two products of at most `most` each, through at most four roundings of 2^-53 each.
  constexpr double kRounding = 0x1p-49;
  if (most.minCoeff() >= kLeast && most.maxCoeff() <= kGreatest) {
    if (std::abs(left - right) > kRounding * (most.x() * most.y())) return sign_of(left - right);
  } else if (most.minCoeff() == 0) {
    return 0;
  }
  return exact_orient2d(a, b, c);
}

}  // namespace whittle::detail
