/// \file
/// The moves of the vertices that bring a simplified mesh closest to the samples of the original.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/refit/Fitted.hh"
#include "whittle/refit/samples.hh"

namespace whittle::refitting {

using mq::SymmetricMatrix;

/// A face's share of the normal equations.
struct Equations {
  std::array<SymmetricMatrix, 3> own;   ///< of each corner
  std::array<SymmetricMatrix, 3> with;  ///< of each corner and the next
  std::array<Vec, 3> sides{Vec::Zero(), Vec::Zero(), Vec::Zero()};
};

/// Least squares of the samples' distances from the faces. What the samples leave open the faces' own planes hold, the more
/// the fewer samples there are.
inline std::vector<Equations> equations(const Fitted& fitted, const std::vector<Sample>& samples,
                                        std::size_t n_original_faces, detail::Crew& crew) {
  constexpr float kHold = 0.4f;
  const std::size_t n = fitted.faces.size(), at_once = (n + crew.size() - 1) / crew.size();
  const float hold = kHold * static_cast<float>(n) / static_cast<float>(n_original_faces) / 3;
  std::vector<Equations> all(n);
  // Each range goes through all samples: the sums are the same for any number of threads.
  crew.each_range(n, at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      all[f].own.fill(SymmetricMatrix::outer(fitted.faces[f].normal, hold * fitted.faces[f].area));
    for (const Sample& sample : samples) {
      if (sample.face < begin || sample.face >= end) continue;
      Equations& own = all[sample.face];
      for (std::size_t k = 0; k < 3; ++k) {
        const float here = sample.at[k], next = sample.at[(k + 1) % 3];
        own.own[k] += SymmetricMatrix::outer(sample.normal, here * here);
        own.with[k] += SymmetricMatrix::outer(sample.normal, here * next);
        own.sides[k] += (here * sample.distance) * sample.normal;
      }
    }
  });
  return all;
}

/// Solves by Gauss-Seidel, vertex by vertex.
class Solver {
 public:
  /// \param upright  for each face its normal in the original, of any length
  Solver(Fitted& fitted, const std::vector<Equations>& equations, const std::vector<Vec>& upright)
      : fitted_(fitted),
        equations_(equations),
        upright_(upright),
        start_(fitted.points),
        moves_(fitted.points.size(), Vec::Zero()) {}

  /// \return how many moves were refused.
  std::size_t sweep() {
    std::size_t refused = 0;
    for (std::uint32_t v = 0; v < start_.size(); ++v) {
      if (!fitted_.is_free[v]) continue;
      const Vec move = best_move(v);
      if (move == moves_[v]) continue;
      if (!is_allowed(v, start_[v] + move)) {
        ++refused;
        continue;
      }
      moves_[v] = move;
      fitted_.points[v] = start_[v] + move;
    }
    return refused;
  }

 private:
  /// Where the neighbours' moves leave the least error; at most a fifth of the shortest edge long.
  Vec best_move(std::uint32_t v) const {
    constexpr float kPull = 1e-3f, kFarthest = 0.2f;
    SymmetricMatrix sum;
    Vec side = Vec::Zero();
    float shortest = std::numeric_limits<float>::infinity();
    const auto [begin, end] = fitted_.corners.of(v);
    for (const std::uint32_t* c = begin; c != end; ++c) {
      const Equations& face = equations_[*c / 3];
      const Triangle& t = fitted_.triangles[*c / 3];
      const std::size_t k = *c % 3, next = (k + 1) % 3, previous = (k + 2) % 3;
      sum += face.own[k];
      side += face.sides[k] - face.with[k] * moves_[t[next]] - face.with[previous] * moves_[t[previous]];
      shortest = std::min(shortest, (start_[t[next]] - start_[v]).squaredNorm());
    }
    if (!(sum.trace() > 0)) return moves_[v];
    Vec pivots;
    const Vec move = (sum + SymmetricMatrix::identity(kPull * sum.trace())).solve(side, pivots);
    if (!(pivots.minCoeff() > 0) || !move.allFinite()) return moves_[v];
    const float length = move.norm(), farthest = kFarthest * std::sqrt(shortest);
    return length > farthest ? Vec(move * (farthest / length)) : move;
  }

  /// Whether no face around turns by more than about 45 degrees, or over against the original.
  bool is_allowed(std::uint32_t v, const Vec& there) const {
    constexpr float kLeastCosine = 0.7f;
    const auto [begin, end] = fitted_.corners.of(v);
    for (const std::uint32_t* c = begin; c != end; ++c) {
      const std::uint32_t f = *c / 3;
      const Triangle& t = fitted_.triangles[f];
      const Vec normal =
          (fitted_.points[t[(*c + 1) % 3]] - there).cross(fitted_.points[t[(*c + 2) % 3]] - there);
      const Vec& before = fitted_.faces[f].normal;
      const float length = normal.norm(), upright = upright_[f].dot(normal);
      if (fitted_.faces[f].area > 0 && !(before.dot(normal) > kLeastCosine * length)) return false;
      if (!(upright > 0) && !(upright >= upright_[f].dot(before) * length)) return false;
    }
    return true;
  }

  Fitted& fitted_;
  const std::vector<Equations>& equations_;
  const std::vector<Vec>& upright_;
  std::vector<Vec> start_, moves_;
};

}  // namespace whittle::refitting
