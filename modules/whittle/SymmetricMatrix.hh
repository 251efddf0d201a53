/// \file
/// A symmetric 3x3 matrix of floats.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace whittle {

/// Six floats; what mq's quadrics are made of.
struct SymmetricMatrix {
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  static SymmetricMatrix identity(float s) { return {s, 0, 0, s, 0, s}; }
  /// s v vT
  static SymmetricMatrix outer(const Eigen::Vector3f& v, float s) {
    const float x = s * v.x(), y = s * v.y(), z = s * v.z();
    return {x * v.x(), x * v.y(), x * v.z(), y * v.y(), y * v.z(), z * v.z()};
  }
  /// v wT + w vT
  static SymmetricMatrix both(const Eigen::Vector3f& v, const Eigen::Vector3f& w) {
    return {2 * v.x() * w.x(), v.x() * w.y() + v.y() * w.x(), v.x() * w.z() + v.z() * w.x(),
            2 * v.y() * w.y(), v.y() * w.z() + v.z() * w.y(), 2 * v.z() * w.z()};
  }

  SymmetricMatrix& operator+=(const SymmetricMatrix& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  SymmetricMatrix& operator-=(const SymmetricMatrix& o) {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }
  friend SymmetricMatrix operator*(float s, const SymmetricMatrix& a) {
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
  }
  friend SymmetricMatrix operator+(SymmetricMatrix a, const SymmetricMatrix& b) { return a += b; }
  friend SymmetricMatrix operator-(SymmetricMatrix a, const SymmetricMatrix& b) { return a -= b; }

  float trace() const { return xx + yy + zz; }
  Eigen::Vector3f operator*(const Eigen::Vector3f& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  /// The u for which this matrix times u is b. By L D LT, so the matrix must be positive definite; if
  /// rounding has made it anything else, not all of u is finite.
  Eigen::Vector3f solve(const Eigen::Vector3f& b) const {
    const float a = 1 / xx, l10 = xy * a, l20 = xz * a;
    const float d1 = yy - l10 * xy, c = 1 / d1, e = yz - l10 * xz, l21 = e * c;
    const float d2 = zz - l20 * xz - l21 * e;
    const float y1 = b.y() - l10 * b.x(), y2 = b.z() - l20 * b.x() - l21 * y1;
    if (!(xx > 0 && d1 > 0 && d2 > 0)) return Eigen::Vector3f::Constant(NAN);
    const float z = y2 / d2, y = y1 * c - l21 * z;
    return {b.x() * a - l10 * y - l20 * z, y, z};
  }
};

}  // namespace whittle
