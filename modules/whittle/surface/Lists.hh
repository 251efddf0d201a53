/// \file
/// Lists of numbers in one array.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace whittle::detail {

/// A list of numbers for each of a range of numbers, in one array.
class Lists {
 public:
  using Range = std::pair<const std::uint32_t*, const std::uint32_t*>;

  Lists() = default;

  /// Number i goes to the list of `key(i)`, for each i below `n`, in ascending order.
  template <typename Key>
  Lists(std::size_t n_lists, std::size_t n, Key key) : first_(n_lists + 1, 0), items_(n) {
    for (std::size_t i = 0; i < n; ++i) ++first_[key(i) + 1];
    for (std::size_t l = 0; l < n_lists; ++l) first_[l + 1] += first_[l];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < n; ++i) items_[next[key(i)]++] = static_cast<std::uint32_t>(i);
  }

  /// For each vertex its corners: corner k of triangle f is number 3 f + k.
  static Lists of_corners(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                          std::size_t n_vertices) {
    Lists lists;
    lists.first_.resize(n_vertices + 1, 0);
    for (const auto& t : triangles)
      for (const std::uint32_t v : t) ++lists.first_[v];
    std::size_t sum = 0;
    for (std::size_t& n : lists.first_) n = std::exchange(sum, sum + n);
    lists.items_.resize(3 * triangles.size());
    std::uint32_t corner = 0;
    for (const auto& t : triangles)
      for (const std::uint32_t v : t) lists.items_[lists.first_[v]++] = corner++;
    // Filling has moved each start to that of the next list.
    std::copy_backward(lists.first_.begin(), lists.first_.end() - 1, lists.first_.end());
    lists.first_[0] = 0;
    return lists;
  }

  Range of(std::size_t list) const {
    return {items_.data() + first_[list], items_.data() + first_[list + 1]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> items_;
};

}  // namespace whittle::detail
