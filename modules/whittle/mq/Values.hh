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
/// sums of g and of the weights are kept. NaN, or more than any sensible length, means that a vertex has no single value,
/// as on a seam; its faces are left out for that value.
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
  /// The values of a vertex, and after them 1 for each that it has and 0 for each that it lacks. Reads of four may go
  /// beyond them.
  using Record = std::array<float, 2 * kMost + 4>;
  /// Four triangles p q r: where their corners lie, and their records. After each position there is another float.
  struct FourFaces {
    std::array<const float*, 4> p, q, r, at_p, at_q, at_r;
  };

  Values() = default;
  /// \param values  `count` for each vertex
  Values(const std::vector<float>& values, std::size_t count)
      : n_(count), records_(2 * values.size() + 4, 0), slopes_(values.size(), Slope::Zero()) {
    constexpr float kLargest = 1e18f;  // its square is still a float
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool is_known = std::abs(values[i]) <= kLargest;
      float* const at = &records_[i / n_ * 2 * n_ + i % n_];
      at[0] = is_known ? values[i] : 0;
      at[n_] = is_known ? 1 : 0;
    }
    known_.resize(values.size() / n_);
    for (std::uint32_t v = 0; v < known_.size(); ++v) note_known(v);
  }

  bool empty() const { return n_ == 0; }
  /// The record of a vertex.
  const float* at(std::uint32_t v) const { return &records_[2 * n_ * v]; }

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

  /// Which values a vertex has: a bit for each.
  unsigned known(std::uint32_t v) const { return known_[v]; }

  /// The values at a share of the way from a to b.
  Record between(std::uint32_t a, std::uint32_t b, float share) const {
    Record out{};
    for (std::size_t i = 0; i < n_; ++i) {
      out[i] = at(a)[i] + share * (at(b)[i] - at(a)[i]);
      out[n_ + i] = at(a)[n_ + i] * at(b)[n_ + i];
    }
    return out;
  }
  void set(std::uint32_t v, const Record& record, const Term& term) {
    std::copy_n(record.begin(), 2 * n_, records_.begin() + static_cast<std::ptrdiff_t>(2 * n_ * v));
    std::copy_n(term.slopes.begin(), n_, slopes_.begin() + static_cast<std::ptrdiff_t>(n_ * v));
    note_known(v);
  }

  /// What four edges e from a to b add to the quadrics at a and at b.
  std::array<FourMatrices, 2> along(const std::array<std::uint32_t, 4>& a,
                                    const std::array<std::uint32_t, 4>& b, const FourVectors& e) const;

 private:
  static constexpr float kSliver = 1e-6f;  // the slope of a thinner face is not reliable

  /// The numbers of four records, each number of all four together.
  using FourRecords = std::array<Four, 2 * kMost + 4>;
  void gather(const std::array<const float*, 4>& records, FourRecords& out) const {
    for (std::size_t i = 0; i < 2 * n_; i += 4) {
      const auto columns = transposed({records[0] + i, records[1] + i, records[2] + i, records[3] + i});
      std::copy(columns.begin(), columns.end(), out.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void note_known(std::uint32_t v) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < n_; ++i) bits |= at(v)[n_ + i] > 0 ? 1u << i : 0u;
    known_[v] = static_cast<std::uint16_t>(bits);
  }

  std::size_t n_ = 0;
  std::vector<float> records_;
  std::vector<std::uint16_t> known_;
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
    if (at_p[n_ + i] * at_q[n_ + i] * at_r[n_ + i] == 0 || !slope.allFinite()) continue;
    term.form += SymmetricMatrix::outer(slope, weight);
    term.slopes[i] = {weight * slope.x(), weight * slope.y(), weight * slope.z(), weight};
  }
  return term;
}

inline void Values::terms(const FourFaces& faces, std::array<Term, 4>& out) const {
  const FourVectors p = gathered(faces.p), e = gathered(faces.q) - p, f = gathered(faces.r) - p;
  const FourVectors n = e.cross(f);
  const Four square = n.squaredNorm(), weight = square_roots(square);
  const FourVectors by_e = f.cross(n) / square, by_f = n.cross(e) / square;
  const Four excess = square - kSliver * e.squaredNorm() * f.squaredNorm();
  FourRecords at_p, at_q, at_r;
  gather(faces.at_p, at_p);
  gather(faces.at_q, at_q);
  gather(faces.at_r, at_r);
  FourMatrices form;
  Four sum(0.0f);
  for (std::size_t i = 0; i < n_; ++i) {
    const FourVectors slope = (at_q[i] - at_p[i]) * by_e + (at_r[i] - at_p[i]) * by_f;
    const Four counted = at_p[n_ + i] * at_q[n_ + i] * at_r[n_ + i] * weight;
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

inline std::array<FourMatrices, 2> Values::along(const std::array<std::uint32_t, 4>& a,
                                                 const std::array<std::uint32_t, 4>& b,
                                                 const FourVectors& e) const {
  const Four square = e.squaredNorm();
  Four has_length(1.0f);
  if (!(square.minCoeff() > 0))
    for (Eigen::Index k = 0; k < 4; ++k) has_length[k] = square[k] > 0 ? 1 : 0;
  const Four divisor = square.max(std::numeric_limits<float>::min());
  const auto records = [&](const std::array<std::uint32_t, 4>& v, FourRecords& out) {
    gather({at(v[0]), at(v[1]), at(v[2]), at(v[3])}, out);
  };
  FourRecords at_a, at_b;
  records(a, at_a);
  records(b, at_b);
  std::array<FourMatrices, 2> sums;
  for (std::size_t i = 0; i < n_; ++i) {
    const Four difference = (at_b[i] - at_a[i]) * (at_a[n_ + i] * at_b[n_ + i] * has_length);
    const FourVectors m = difference / divisor * e;
    const auto add = [&](FourMatrices& sum, const std::array<std::uint32_t, 4>& v) {
      const auto slope = [&](std::size_t k) { return slopes_[n_ * v[k] + i].data(); };
      const auto columns = transposed({slope(0), slope(1), slope(2), slope(3)});
      sum += FourMatrices::outer(m, columns[3]) - FourMatrices::both(m, {columns[0], columns[1], columns[2]});
    };
    add(sums[0], a);
    add(sums[1], b);
  }
  return sums;
}

}  // namespace whittle::mq
