/// \file
/// Error of normals, colours and texture coordinates, as quadratic forms.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "whittle/mq/Four.hh"
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

  /// Of one value: the sum over faces of slope times weight, and in the fourth place that of the weights.
  using Slope = Eigen::Vector4f;
  /// What faces add to a vertex.
  struct Term {
    SymmetricMatrix form;             ///< the sum of g gT
    std::array<Slope, kMost> slopes;  ///< as many as there are values; the others are undefined
  };
  /// Four triangles p q r: where their corners lie, and what values they have. After each position there is another
  /// float.
  struct FourFaces {
    std::array<const float*, 4> p, q, r, at_p, at_q, at_r;
  };

  Values() = default;
  /// \param values  `count` for each vertex
  Values(std::vector<float> values, std::size_t count)
      : n_(count), values_(std::move(values)), slopes_(values_.size(), Slope::Zero()) {}

  bool empty() const { return n_ == 0; }
  const float* at(std::uint32_t v) const { return &values_[n_ * v]; }

  /// What the face p q r adds to each of its corners.
  Term term(const Vec& p, const Vec& q, const Vec& r, const float* at_p, const float* at_q,
            const float* at_r) const;
  /// The same for four faces.
  void terms(const FourFaces& faces, std::array<Term, 4>& out) const;
  /// Of no faces.
  Term no_term() const {
    Term term;
    std::fill_n(term.slopes.begin(), n_, Slope::Zero());
    return term;
  }

  void add(std::uint32_t v, const Term& term) {
    for (std::size_t i = 0; i < n_; ++i) slopes_[n_ * v + i] += term.slopes[i];
  }
  void subtract(std::uint32_t v, const Term& term) {
    for (std::size_t i = 0; i < n_; ++i) slopes_[n_ * v + i] -= term.slopes[i];
  }
  void add(Term& sum, const Term& term) const {
    sum.form += term.form;
    for (std::size_t i = 0; i < n_; ++i) sum.slopes[i] += term.slopes[i];
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
  /// The same for four edges, at both ends.
  std::array<FourMatrices, 2> along(const std::array<std::uint32_t, 4>& a,
                                    const std::array<std::uint32_t, 4>& b, const FourVectors& e) const;

 private:
  static constexpr float kSliver = 1e-6f;  // the slope of a thinner face is not reliable

  std::size_t n_ = 0;
  std::vector<float> values_;
  std::vector<Slope> slopes_;
};

inline auto Values::term(const Vec& p, const Vec& q, const Vec& r, const float* at_p, const float* at_q,
                         const float* at_r) const -> Term {
  Term term = no_term();
  const Vec e = q - p, f = r - p, n = e.cross(f);
  const float square = n.squaredNorm();
  if (!(square > kSliver * e.squaredNorm() * f.squaredNorm())) return term;
  const float weight = std::sqrt(square);
  const Vec by_e = f.cross(n) / square, by_f = n.cross(e) / square;
  for (std::size_t i = 0; i < n_; ++i) {
    const Vec slope = (at_q[i] - at_p[i]) * by_e + (at_r[i] - at_p[i]) * by_f;
    if (!slope.allFinite()) continue;
    term.form += SymmetricMatrix::outer(slope, weight);
    term.slopes[i] << weight * slope, weight;
  }
  return term;
}

inline void Values::terms(const FourFaces& faces, std::array<Term, 4>& out) const {
  const FourVectors p = gathered(faces.p), e = gathered(faces.q) - p, f = gathered(faces.r) - p;
  const FourVectors n = e.cross(f);
  const Four square = n.squaredNorm(), weight = square_roots(square);
  const FourVectors by_e = f.cross(n) / square, by_f = n.cross(e) / square;
  const Four excess = square - kSliver * e.squaredNorm() * f.squaredNorm();
  FourMatrices form;
  Four sum(0.0f);
  for (std::size_t i = 0; i < n_; ++i) {
    Four to_q, to_r, is_known;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto lane = static_cast<Eigen::Index>(k);
      const float value = faces.at_p[k][i], q = faces.at_q[k][i] - value, r = faces.at_r[k][i] - value;
      const bool known = std::isfinite(q) && std::isfinite(r);
      to_q[lane] = known ? q : 0;
      to_r[lane] = known ? r : 0;
      is_known[lane] = known ? 1 : 0;
    }
    const FourVectors slope = to_q * by_e + to_r * by_f;
    const Four counted = is_known * weight;
    form += FourMatrices::outer(slope, counted);
    sum += slope.x() + slope.y() + slope.z();
    const Eigen::Matrix4f slopes =
        transposed(counted * slope.x(), counted * slope.y(), counted * slope.z(), counted);
    for (std::size_t k = 0; k < 4; ++k) out[k].slopes[i] = slopes.col(static_cast<Eigen::Index>(k));
  }
  const auto forms = apart(form);
  for (std::size_t k = 0; k < 4; ++k) out[k].form = forms[k];
  if (excess.minCoeff() > 0 && (0 * sum).sum() == 0) return;
  const auto vec = [](const float* x) { return Vec(x[0], x[1], x[2]); };
  for (std::size_t k = 0; k < 4; ++k)
    out[k] =
        term(vec(faces.p[k]), vec(faces.q[k]), vec(faces.r[k]), faces.at_p[k], faces.at_q[k], faces.at_r[k]);
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
    sum += SymmetricMatrix::outer(m, slope.w()) - SymmetricMatrix::both(m, slope.head<3>());
  }
  return sum;
}

inline std::array<FourMatrices, 2> Values::along(const std::array<std::uint32_t, 4>& a,
                                                 const std::array<std::uint32_t, 4>& b,
                                                 const FourVectors& e) const {
  std::array<FourMatrices, 2> sums;
  const Four square = e.squaredNorm();
  for (std::size_t i = 0; i < n_; ++i) {
    Four difference;
    std::array<const float*, 4> at_a, at_b;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto lane = static_cast<Eigen::Index>(k);
      const std::size_t from = n_ * a[k] + i, to = n_ * b[k] + i;
      const float d = values_[to] - values_[from];
      difference[lane] = std::isfinite(d) && square[lane] > 0 ? d : 0;
      at_a[k] = slopes_[from].data();
      at_b[k] = slopes_[to].data();
    }
    const FourVectors m = difference / square.max(std::numeric_limits<float>::min()) * e;
    const auto add = [&m](FourMatrices& sum, const std::array<const float*, 4>& slopes) {
      const auto columns = transposed(slopes);
      sum += FourMatrices::outer(m, columns[3]) - FourMatrices::both(m, {columns[0], columns[1], columns[2]});
    };
    add(sums[0], at_a);
    add(sums[1], at_b);
  }
  return sums;
}

}  // namespace whittle::mq
