/// \file
/// Four numbers, vectors or symmetric matrices in SIMD lanes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "whittle/mq/SymmetricMatrix.hh"

namespace whittle::mq {

/// Eigen compiles this to SIMD instructions where the processor has them. Results are the same to the bit on
/// every processor as long as only + - * / and comparisons are used.
using Four = Eigen::Array4f;

/// Four vectors, stored by coordinate.
class FourVectors {
 public:
  using Scalar = Four;

  FourVectors() = default;  ///< uninitialised
  FourVectors(const Four& x, const Four& y, const Four& z) : x_(x), y_(y), z_(z) {}

  const Four& x() const { return x_; }
  const Four& y() const { return y_; }
  const Four& z() const { return z_; }

  friend FourVectors operator+(const FourVectors& a, const FourVectors& b) {
    return {a.x_ + b.x_, a.y_ + b.y_, a.z_ + b.z_};
  }
  friend FourVectors operator-(const FourVectors& a, const FourVectors& b) {
    return {a.x_ - b.x_, a.y_ - b.y_, a.z_ - b.z_};
  }
  friend FourVectors operator*(const Four& s, const FourVectors& a) { return {s * a.x_, s * a.y_, s * a.z_}; }
  friend FourVectors operator/(const FourVectors& a, const Four& s) { return {a.x_ / s, a.y_ / s, a.z_ / s}; }
  Four dot(const FourVectors& b) const { return x_ * b.x_ + (y_ * b.y_ + z_ * b.z_); }
  Four squaredNorm() const { return dot(*this); }
  FourVectors cross(const FourVectors& b) const {
    return {y_ * b.z_ - z_ * b.y_, z_ * b.x_ - x_ * b.z_, x_ * b.y_ - y_ * b.x_};
  }

 private:
  Four x_, y_, z_;
};

using FourMatrices = SymmetricMatrixOf<FourVectors>;

/// The square of a shorter vector is not told from 0 in float.
constexpr float kLeastLength = 1e-18f;

EIGEN_ALWAYS_INLINE Four square_roots(const Four& squares) {
  // Not by `squares.sqrt()`, which is an approximation that differs between processors.
#if defined(__SSE__)
  Four roots;
  _mm_storeu_ps(roots.data(), _mm_sqrt_ps(_mm_loadu_ps(squares.data())));
  return roots;
#else
  return {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]), std::sqrt(squares[3])};
#endif
}

/// 1 / |v| for vectors with these squared lengths; at most 1 / `kLeastLength`.
EIGEN_ALWAYS_INLINE Four reciprocal_lengths(const Four& squares) {
  return 1 / square_roots(squares).max(kLeastLength);
}

/// Four rows of four floats to four columns, or back.
EIGEN_ALWAYS_INLINE std::array<Four, 4> transposed(const std::array<const float*, 4>& rows) {
  std::array<Four, 4> columns;
#if defined(__SSE__)
  __m128 a = _mm_loadu_ps(rows[0]), b = _mm_loadu_ps(rows[1]), c = _mm_loadu_ps(rows[2]),
         d = _mm_loadu_ps(rows[3]);
  _MM_TRANSPOSE4_PS(a, b, c, d);
  _mm_storeu_ps(columns[0].data(), a);
  _mm_storeu_ps(columns[1].data(), b);
  _mm_storeu_ps(columns[2].data(), c);
  _mm_storeu_ps(columns[3].data(), d);
#else
  for (std::size_t i = 0; i < 4; ++i) columns[i] = {rows[0][i], rows[1][i], rows[2][i], rows[3][i]};
#endif
  return columns;
}
EIGEN_ALWAYS_INLINE Eigen::Matrix4f transposed(const Four& a, const Four& b, const Four& c, const Four& d) {
  const auto columns = transposed({a.data(), b.data(), c.data(), d.data()});
  Eigen::Matrix4f m;
  for (std::size_t i = 0; i < 4; ++i) m.col(static_cast<Eigen::Index>(i)) = columns[i].matrix();
  return m;
}

/// Loads four vectors from anywhere in memory; each must have another float after it.
EIGEN_ALWAYS_INLINE FourVectors gathered(const std::array<const float*, 4>& vectors) {
  const auto columns = transposed(vectors);
  return {columns[0], columns[1], columns[2]};
}
/// Loads four matrices from anywhere in memory.
EIGEN_ALWAYS_INLINE FourMatrices gathered(const std::array<const SymmetricMatrix*, 4>& m) {
  std::array<const float*, 4> head, tail;  // xx xy xz yy and xz yy yz zz
  for (std::size_t i = 0; i < 4; ++i) {
    head[i] = &m[i]->xx;
    tail[i] = &m[i]->xz;
  }
  const auto first = transposed(head), last = transposed(tail);
  return {first[0], first[1], first[2], first[3], last[2], last[3]};
}

/// One of the four matrices.
inline SymmetricMatrix one_of(const FourMatrices& m, Eigen::Index lane) {
  return {m.xx[lane], m.xy[lane], m.xz[lane], m.yy[lane], m.yz[lane], m.zz[lane]};
}
/// The four matrices one by one.
EIGEN_ALWAYS_INLINE std::array<SymmetricMatrix, 4> apart(const FourMatrices& m) {
  const Eigen::Matrix4f head = transposed(m.xx, m.xy, m.xz, m.yy);
  std::array<SymmetricMatrix, 4> matrices;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    Eigen::Vector4f::Map(&matrices[i].xx) = head.col(k);
    matrices[i].yz = m.yz[k];
    matrices[i].zz = m.zz[k];
  }
  return matrices;
}

/// The four vectors one by one.
EIGEN_ALWAYS_INLINE std::array<Eigen::Vector3f, 4> apart(const FourVectors& v) {
  const Eigen::Matrix4f columns = transposed(v.x(), v.y(), v.z(), Four(0.0f));
  std::array<Eigen::Vector3f, 4> vectors;
  for (std::size_t i = 0; i < 4; ++i) vectors[i] = columns.col(static_cast<Eigen::Index>(i)).head<3>();
  return vectors;
}

}  // namespace whittle::mq
