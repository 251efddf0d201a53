/// \file
/// The nearest point of a mesh's faces, found by walking there from a face nearby.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "whittle/openmesh/InputFaces.hh"
#include "whittle/surface/triangle.hh"

namespace whittle::detail {

/// Goes over the faces of a mesh as it was; seams of half-edge texture coordinates part faces as the boundary does.
class FaceWalk {
 public:
  static constexpr std::uint32_t kNone = InputFaces::kNone;

  /// A point of a face: the corners' shares of it, which add up to 1.
  struct Spot {
    std::uint32_t face = kNone;
    std::array<double, 3> shares{1, 0, 0};
    double squares = HUGE_VAL;  ///< of the distance
  };

  FaceWalk() = default;
  /// The input must outlive this.
  explicit FaceWalk(const InputFaces& input) : input_(&input) {}

  /// Goes from a face to ever nearer ones, as long as there is one among those around the corners of the last. No seam is
  /// crossed on the way.
  Spot nearest(const Eigen::Vector3d& p, std::uint32_t start) const;

 private:
  static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static std::uint32_t previous(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
  std::uint32_t twin(std::uint32_t side) const { return input_->twin[side]; }

  void look(const Eigen::Vector3d& p, std::uint32_t face, Spot& best) const;
  void look_around(const Eigen::Vector3d& p, std::uint32_t corner, Spot& best) const;

  const InputFaces* input_ = nullptr;
};

inline auto FaceWalk::nearest(const Eigen::Vector3d& p, std::uint32_t start) const -> Spot {
  Spot best;
  best.face = start;  // whatever its shape
  look(p, start, best);
  for (std::uint32_t at = kNone; at != best.face;) {
    at = best.face;
    for (std::uint32_t corner = 3 * at; corner < 3 * at + 3; ++corner) look_around(p, corner, best);
  }
  return best;
}

inline void FaceWalk::look(const Eigen::Vector3d& p, std::uint32_t face, Spot& best) const {
  const auto& t = input_->triangles[face];
  const Eigen::Vector3d &a = input_->points[t[0]], &b = input_->points[t[1]], &c = input_->points[t[2]];
  at_closest_point(p, a, b, c, [&](const Eigen::Vector3d& corner, const auto&... step) {
    Eigen::Vector3d offset = p - corner;
    ((offset -= step.share * step.side), ...);
    const double squares = offset.squaredNorm();
    if (!(squares < best.squares)) return;
    best = {face, {0, 0, 0}, squares};
    double rest = 1;
    [[maybe_unused]] const auto go = [&](std::size_t to, double share) {
      best.shares[to] += share;
      rest -= share;
    };
    if constexpr (sizeof...(step) == 2) {  // from a towards b and c
      std::size_t to = 1;
      (go(to++, step.share), ...);
    } else if constexpr (sizeof...(step) == 1) {  // along ab, ac or bc
      (go(&corner == &a && step.side == b - a ? 1 : 2, step.share), ...);
    }
    best.shares[&corner == &a ? 0 : &corner == &b ? 1 : 2] += rest;
  });
}

inline void FaceWalk::look_around(const Eigen::Vector3d& p, std::uint32_t corner, Spot& best) const {
  std::uint32_t at = corner;
  while ((at = twin(previous(at))) != kNone) {
    if (at == corner) return;
    look(p, at / 3, best);
  }
  for (at = corner; (at = twin(at)) != kNone;) look(p, (at = next(at)) / 3, best);
}

}  // namespace whittle::detail
