/// \file
/// Boxes around the faces of a mesh, and around those.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/surface/threads.hh"

namespace whittle::detail {

/// Boxes that may touch, closed.
struct FaceBox {
  Eigen::Array3d low = Eigen::Array3d::Constant(HUGE_VAL),
                 high = Eigen::Array3d::Constant(-HUGE_VAL);  ///< of nothing

  FaceBox() = default;
  FaceBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
      : low(a.cwiseMin(b).cwiseMin(c)), high(a.cwiseMax(b).cwiseMax(c)) {}

  bool touches(const FaceBox& other) const { return (low <= other.high).all() && (other.low <= high).all(); }
  void add(const FaceBox& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
};

/// The faces in the order of a curve through space, some at a time in a leaf, and a binary tree over the leaves.
class FaceTree {
 public:
  static constexpr std::size_t kLeaf = 4;  ///< faces
  using Triangle = std::array<std::uint32_t, 3>;

  /// \param place  the place of a vertex, finite coordinates in an Eigen::Vector3d
  template <typename Place>
  FaceTree(const std::vector<Triangle>& triangles, const Place& place, Crew& crew);

  std::size_t n_leaves() const { return levels_.empty() ? 0 : levels_.front().size(); }

  /// Calls `visit(f, g)`, until it returns false, for each pair of faces whose boxes touch and the first of which, in the
  /// order of the curve, lies in the leaf.
  /// \return whether it has never returned false
  template <typename Visit>
  bool pairs_of(std::size_t leaf, const Visit& visit) const {
    return levels_.empty() || descend(levels_.size() - 1, 0, leaf, visit);
  }

 private:
  static constexpr std::size_t kAtOnce = 4096;

  template <typename Visit>
  bool descend(std::size_t level, std::size_t node, std::size_t leaf, const Visit& visit) const;
  template <typename Visit>
  bool pairs_between(std::size_t leaf, std::size_t other, const Visit& visit) const;
  void sort(Crew& crew);
  FaceBox leaf_box(std::size_t leaf) const {
    FaceBox box;
    for (std::size_t i = leaf * kLeaf; i < std::min(boxes_.size(), (leaf + 1) * kLeaf); ++i)
      box.add(boxes_[i]);
    return box;
  }
  FaceBox inner_box(std::size_t level, std::size_t node) const {
    const auto& below = levels_[level - 1];
    FaceBox box = below[2 * node];
    if (2 * node + 1 < below.size()) box.add(below[2 * node + 1]);
    return box;
  }

  std::vector<std::uint32_t> faces_;          // by the curve
  std::vector<FaceBox> boxes_;                // of them
  std::vector<std::vector<FaceBox>> levels_;  // of leaves, of pairs of leaves, and so on to the root
};

template <typename Place>
FaceTree::FaceTree(const std::vector<Triangle>& triangles, const Place& place, Crew& crew)
    : faces_(triangles.size()), boxes_(triangles.size()) {
  if (triangles.empty()) return;
  crew.each_range(triangles.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      boxes_[f] = FaceBox(place(triangles[f][0]), place(triangles[f][1]), place(triangles[f][2]));
  });
  sort(crew);
  levels_.emplace_back((faces_.size() + kLeaf - 1) / kLeaf);
  for (std::size_t leaf = 0; leaf < levels_[0].size(); ++leaf) levels_[0][leaf] = leaf_box(leaf);
  while (levels_.back().size() > 1) {
    levels_.emplace_back((levels_.back().size() + 1) / 2);
    const std::size_t level = levels_.size() - 1;
    for (std::size_t node = 0; node < levels_[level].size(); ++node)
      levels_[level][node] = inner_box(level, node);
  }
}

/// By the Morton codes of the boxes' middles.
inline void FaceTree::sort(Crew& crew) {
  FaceBox whole = boxes_.front();
  for (const FaceBox& box : boxes_) whole.add(box);
  constexpr double kCells = 1 << 21;
  const auto spread = [](std::uint64_t x) {  // bit i goes to bit 3 i
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  };
  // Halves, as the sum or the difference of two doubles may be none.
  const Eigen::Array3d extent = whole.high / 2 - whole.low / 2;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(boxes_.size());
  crew.each_range(boxes_.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Eigen::Array3d middle =
          (boxes_[f].low / 2 - whole.low / 2) / 2 + (boxes_[f].high / 2 - whole.low / 2) / 2;
      std::uint64_t key = 0;
      for (Eigen::Index k = 0; k < 3; ++k) {
        const double share = extent[k] > 0 ? middle[k] / extent[k] : 0;  // NaN is in the first cell
        const double cell = share > 0 ? std::min(share * kCells, kCells - 1) : 0;
        key |= spread(static_cast<std::uint64_t>(cell)) << k;
      }
      keys[f] = {key, static_cast<std::uint32_t>(f)};
    }
  });
  std::sort(keys.begin(), keys.end());
  std::vector<FaceBox> sorted(boxes_.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    faces_[i] = keys[i].second;
    sorted[i] = boxes_[keys[i].second];
  }
  boxes_ = std::move(sorted);
}

template <typename Visit>
bool FaceTree::descend(std::size_t level, std::size_t node, std::size_t leaf, const Visit& visit) const {
  if (((node + 1) << level) <= leaf || !levels_[level][node].touches(levels_.front()[leaf])) return true;
  if (level == 0) return pairs_between(leaf, node, visit);
  if (!descend(level - 1, 2 * node, leaf, visit)) return false;
  return 2 * node + 1 >= levels_[level - 1].size() || descend(level - 1, 2 * node + 1, leaf, visit);
}

template <typename Visit>
bool FaceTree::pairs_between(std::size_t leaf, std::size_t other, const Visit& visit) const {
  const std::size_t end = std::min(faces_.size(), (leaf + 1) * kLeaf),
                    other_end = std::min(faces_.size(), (other + 1) * kLeaf);
  for (std::size_t i = leaf * kLeaf; i < end; ++i)
    for (std::size_t j = std::max(i + 1, other * kLeaf); j < other_end; ++j)
      if (boxes_[i].touches(boxes_[j]) && !visit(faces_[i], faces_[j])) return false;
  return true;
}

}  // namespace whittle::detail
