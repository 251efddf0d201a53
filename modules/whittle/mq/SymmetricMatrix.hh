/// \file
/// A symmetric 3x3 matrix.
#pragma once

#include <Eigen/Core>

namespace whittle::mq {

/// A symmetric 3x3 matrix as six numbers; mq's quadrics are such matrices.
/// \tparam Vector  of three such numbers: Eigen::Vector3f, or FourVectors for four matrices at once.
template <typename Vector>
struct SymmetricMatrixOf {
  using Real = typename Vector::Scalar;
  Real xx = Real(0.0f), xy = Real(0.0f), xz = Real(0.0f), yy = Real(0.0f), yz = Real(0.0f), zz = Real(0.0f);

  static SymmetricMatrixOf identity(const Real& s) {
    const Real zero(0.0f);
    return {s, zero, zero, s, zero, s};
  }
  /// s v vT
  static SymmetricMatrixOf outer(const Vector& v, const Real& s) {
    const Real x = s * v.x(), y = s * v.y(), z = s * v.z();
    return {x * v.x(), x * v.y(), x * v.z(), y * v.y(), y * v.z(), z * v.z()};
  }
  /// v wT + w vT
  static SymmetricMatrixOf both(const Vector& v, const Vector& w) {
    return {2 * v.x() * w.x(), v.x() * w.y() + v.y() * w.x(), v.x() * w.z() + v.z() * w.x(),
            2 * v.y() * w.y(), v.y() * w.z() + v.z() * w.y(), 2 * v.z() * w.z()};
  }

  SymmetricMatrixOf& operator+=(const SymmetricMatrixOf& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  SymmetricMatrixOf& operator-=(const SymmetricMatrixOf& o) {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }
  friend SymmetricMatrixOf operator*(const Real& s, const SymmetricMatrixOf& a) {
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
  }
  friend SymmetricMatrixOf operator+(SymmetricMatrixOf a, const SymmetricMatrixOf& b) { return a += b; }
  friend SymmetricMatrixOf operator-(SymmetricMatrixOf a, const SymmetricMatrixOf& b) { return a -= b; }

  Real trace() const { return xx + yy + zz; }
  Vector operator*(const Vector& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  /// The u for which this matrix times u is b, by L D LT; the matrix must be positive definite.
  /// \param pivots  the diagonal of D; the solution is meaningless where one is not positive.
  Vector solve(const Vector& b, Vector& pivots) const {
    const Real a = 1 / xx, l10 = xy * a, l20 = xz * a;
    const Real d1 = yy - l10 * xy, c = 1 / d1, e = yz - l10 * xz, l21 = e * c;
    const Real d2 = zz - l20 * xz - l21 * e;
    const Real y1 = b.y() - l10 * b.x(), y2 = b.z() - l20 * b.x() - l21 * y1;
    pivots = {xx, d1, d2};
    const Real z = y2 / d2, y = y1 * c - l21 * z;
    return {b.x() * a - l10 * y - l20 * z, y, z};
  }
};

using SymmetricMatrix = SymmetricMatrixOf<Eigen::Vector3f>;

}  // namespace whittle::mq
