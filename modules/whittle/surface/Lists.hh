/// \file
/// Lists of numbers in one array.
#pragma once

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

  Range of(std::size_t list) const {
    return {items_.data() + first_[list], items_.data() + first_[list + 1]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> items_;
};

}  // namespace whittle::detail
