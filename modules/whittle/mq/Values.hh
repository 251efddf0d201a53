/// \file
/// Error of normals, colours and texture coordinates, as quadratic forms.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Vertex.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::mq {

/// Values at the vertices, linear on each face, and the error that moving a vertex causes in them.
///
/// On a face with slope g a value that is s at vertex v is s + g x at the offset x from it. If v moves by x
/// and gets s + d instead, the face's share of the error is its weight times (d - g x) squared. When an edge
/// e merges, d follows x along the edge: d = m x with m = (difference along e) e / |e|². So the error is a
/// quadratic form in x, as that of the planes, and again has neither a linear nor a constant part:
///
///     (m - g)(m - g)T = m mT - (m gT + g mT) + g gT
///
/// The last term does not depend on the edge and is added to the vertex's quadric once; for the others the
/// sums of g and of the weights are kept. NaN means that a vertex has no single value, as on a seam; its
/// faces are left out for that value.
class Values {
 public:
  static constexpr std::size_t kMost = SurfaceExtras::kMostValues;

  /// Of one value: the sum over faces of slope times weight, and that of the weights.
  struct Slope {
    Vec sum = Vec::Zero();
    float weight = 0;
  };
  /// What faces add to a vertex.
  struct Term {
    SymmetricMatrix form;  ///< the sum of g gT
    std::array<Slope, kMost> slopes = {};
  };

  Values() = default;
  /// \param values  `count` for each vertex
  Values(std::vector<float> values, std::size_t count)
      : n_(count), values_(std::move(values)), slopes_(values_.size()) {}

  bool empty() const { return n_ == 0; }
  const float* at(std::uint32_t v) const { return &values_[n_ * v]; }

  /// What the face p q r adds to each of its corners.
  Term term(const Vec& p, const Vec& q, const Vec& r, const float* at_p, const float* at_q,
            const float* at_r) const;

  void add(std::uint32_t v, const Term& term, float factor) {
    for (std::size_t i = 0; i < n_; ++i) {
      slopes_[n_ * v + i].sum += factor * term.slopes[i].sum;
      slopes_[n_ * v + i].weight += factor * term.slopes[i].weight;
    }
  }
  static void add(Term& sum, const Term& term) {
    sum.form += term.form;
    for (std::size_t i = 0; i < kMost; ++i) {
      sum.slopes[i].sum += term.slopes[i].sum;
      sum.slopes[i].weight += term.slopes[i].weight;
    }
  }

  /// The values at a share of the way from a to b.
  std::array<float, kMost> between(std::uint32_t a, std::uint32_t b, float share) const {
    std::array<float, kMost> out{};
    for (std::size_t i = 0; i < n_; ++i) out[i] = at(a)[i] + share * (at(b)[i] - at(a)[i]);
    return out;
  }
  void set(std::uint32_t v, const std::array<float, kMost>& values, const Term& term) {
    for (std::size_t i = 0; i < n_; ++i) {
      values_[n_ * v + i] = values[i];
      slopes_[n_ * v + i] = term.slopes[i];
    }
  }

  /// What the edge e from a to b adds to the quadric of its end v.
  SymmetricMatrix along(std::uint32_t a, std::uint32_t b, const Vec& e, std::uint32_t v) const;

 private:
  std::size_t n_ = 0;
  std::vector<float> values_;
  std::vector<Slope> slopes_;
};

inline auto Values::term(const Vec& p, const Vec& q, const Vec& r, const float* at_p, const float* at_q,
                         const float* at_r) const -> Term {
  Term term;
  const Vec e = q - p, f = r - p, n = e.cross(f);
  const float square = n.squaredNorm();
  constexpr float kSliver = 1e-6f;  // the slope of a thinner face is not reliable
  if (!(square > kSliver * e.squaredNorm() * f.squaredNorm())) return term;
  const float weight = std::sqrt(square);
  const Vec by_e = f.cross(n) / square, by_f = n.cross(e) / square;
  for (std::size_t i = 0; i < n_; ++i) {
    const Vec slope = (at_q[i] - at_p[i]) * by_e + (at_r[i] - at_p[i]) * by_f;
    if (!slope.allFinite()) continue;
    term.form += SymmetricMatrix::outer(slope, weight);
    term.slopes[i] = {weight * slope, weight};
  }
  return term;
}

inline SymmetricMatrix Values::along(std::uint32_t a, std::uint32_t b, const Vec& e, std::uint32_t v) const {
  SymmetricMatrix sum;
  const float square = e.squaredNorm();
  if (!(square > 0)) return sum;
  for (std::size_t i = 0; i < n_; ++i) {
    const float difference = at(b)[i] - at(a)[i];
    if (!std::isfinite(difference)) continue;
    const Vec m = difference / square * e;
    const Slope& slope = slopes_[n_ * v + i];
    sum += SymmetricMatrix::outer(m, slope.weight) - SymmetricMatrix::both(m, slope.sum);
  }
  return sum;
}

}  // namespace whittle::mq
