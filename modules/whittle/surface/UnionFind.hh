/// \file
/// Which of n items are connected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace whittle::detail {

/// Disjoint sets over 0..n-1 with path halving. The smaller index is the root: simple, and fast enough on
/// meshes.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) { reset(size); }

  /// Each item by itself again, and as many as that.
  void reset(std::size_t size) {
    parent_.resize(size);
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t root(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  /// Joins the sets of two items; false if they were one set already.
  bool join(std::uint32_t first, std::uint32_t second) {
    first = root(first);
    second = root(second);
    if (first == second) return false;
    if (second < first) std::swap(first, second);
    parent_[second] = first;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace whittle::detail
