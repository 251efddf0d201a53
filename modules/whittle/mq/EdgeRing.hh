/// \file
/// The faces around an edge that remain when it collapses.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/mq/Corner.hh"
#include "whittle/mq/Four.hh"
#include "whittle/mq/PackedNormal.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Vertex.hh"

namespace whittle::mq {

/// The faces around an edge's two ends that remain when it collapses, and how their normals turn.
class EdgeRing {
 public:
  /// A face with its vertices counter-clockwise: the one that moves, `from`, `to`.
  struct Side {
    std::uint32_t from, to;
    Corner corner;        ///< at the vertex that moves
    PackedNormal normal;  ///< of the face in the input
  };

  void clear() { n_ = 0; }
  void add(const Side& side) {
    if (n_ + 3 >= room_) sides_.resize(room_ = 2 * n_ + 8);
    sides_[n_++] = side;
  }
  /// From here on faces at the second end are added.
  void begin_second_end() { n_at_start_ = n_; }
  std::size_t n_at_start() const { return n_at_start_; }
  std::size_t size() const { return n_; }
  const Side* begin() const { return sides_.data(); }
  const Side* end() const { return sides_.data() + n_; }

  /// Moves the corners at both ends to `target`.
  /// \param limit  the least cosine between a face's normals before and after, squared, with its sign.
  /// \return false  a face turns too far against its normal before or against that in the input.
  bool turn(const std::vector<Vertex>& vertices, std::uint32_t start, std::uint32_t end, const Vec& target,
            float limit);

  /// What the faces around a vertex add up to.
  struct Sums {
    SymmetricMatrix quadric;
    Vec area = Vec::Zero();  ///< see Mesh::areas
  };
  /// After `turn`: calls `add(vertex, change of quadric, change of area)` for each face and the two vertices of it that do
  /// not move.
  /// \return the sums after, for the vertex that does.
  template <typename Add>
  Sums update(Add add) const;

 private:
  /// Normals of four faces, twice their areas long, and their squares.
  struct Turn {
    FourVectors before, after;
    Four before_square, after_square;
  };
  /// The square of the least cosine against the packed normal in the input: just under 90 degrees.
  static constexpr float kUpright = 1e-4f * PackedNormal::kLength * PackedNormal::kLength;

  std::vector<Side> sides_;
  std::size_t room_ = 0, n_ = 0, n_at_start_ = 0;  // room is for three more than n
  std::vector<Turn> turns_;
};

inline bool EdgeRing::turn(const std::vector<Vertex>& vertices, std::uint32_t start, std::uint32_t end,
                           const Vec& target, float limit) {
  if (n_ == 0) return true;
  if (turns_.size() < (n_ + 3) / 4) turns_.resize((n_ + 3) / 4);
  std::fill_n(sides_.begin() + static_cast<std::ptrdiff_t>(n_), 3, sides_[n_ - 1]);  // fills up the last four
  const FourVectors there(Four(target.x()), Four(target.y()), Four(target.z()));
  for (std::size_t i = 0; i < n_; i += 4) {
    std::array<const float*, 4> moving, from, to;
    Eigen::Array<std::uint32_t, 4, 1> normals;
    for (std::size_t k = 0; k < 4; ++k) {
      const Side& side = sides_[i + k];
      moving[k] = vertices[i + k < n_at_start_ ? start : end].position.data();
      from[k] = vertices[side.from].position.data();
      to[k] = vertices[side.to].position.data();
      normals[static_cast<Eigen::Index>(k)] = side.normal.bits();
    }
    const FourVectors p = gathered(moving), q = gathered(from), r = gathered(to),
                      input = PackedNormal::unpacked(normals);
    Turn& turn = turns_[i / 4];
    turn.before = (q - p).cross(r - p);
    turn.after = (q - there).cross(r - there);
    turn.before_square = turn.before.squaredNorm();
    turn.after_square = turn.after.squaredNorm();
    const Four cosine = turn.before.dot(turn.after), overall = input.dot(turn.after);
    const Four guard = cosine * cosine.abs() - limit * turn.before_square * turn.after_square;
    const Four upright = overall * overall.abs() - kUpright * turn.after_square;
    if (!(guard.min(upright).minCoeff() > 0))
      for (Eigen::Index k = 0; k < std::min<Eigen::Index>(4, static_cast<Eigen::Index>(n_ - i)); ++k)
        if ((turn.before_square[k] > 0 && !(guard[k] > 0)) || (normals[k] != 0 && !(upright[k] > 0)))
          return false;
  }
  return true;
}

template <typename Add>
EdgeRing::Sums EdgeRing::update(Add add) const {
  Sums sums;
  for (std::size_t i = 0; i < n_; i += 4) {
    const Turn& turn = turns_[i / 4];
    const FourMatrices before = FourMatrices::outer(turn.before, reciprocal_lengths(turn.before_square)),
                       after = FourMatrices::outer(turn.after, reciprocal_lengths(turn.after_square));
    const auto changes = apart(after - before), now = apart(after);
    const auto turned = apart(turn.after - turn.before), areas = apart(turn.after);
    for (std::size_t k = 0; k < std::min<std::size_t>(4, n_ - i); ++k) {
      sums.quadric += now[k];
      sums.area += areas[k];
      add(sides_[i + k].from, changes[k], turned[k]);
      add(sides_[i + k].to, changes[k], turned[k]);
    }
  }
  return sums;
}

}  // namespace whittle::mq
