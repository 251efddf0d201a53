/// \file
/// Items handed over four at a time, for SIMD.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace whittle::mq {

/// Collects items and calls `take(four items, n)` for every four, and for the last `n` of them with the array
/// filled up by copies of the first.
template <typename Item, typename Take>
class InFours {
 public:
  explicit InFours(Take take) : take_(std::move(take)) {}

  void add(const Item& item) {
    items_[n_++] = item;
    if (n_ == 4) flush();
  }
  /// Hands over what is left; call it at the end.
  void flush() {
    if (n_ == 0) return;
    std::fill(items_.begin() + static_cast<std::ptrdiff_t>(n_), items_.end(), items_[0]);
    take_(items_, n_);
    n_ = 0;
  }

 private:
  Take take_;
  std::array<Item, 4> items_{};
  std::size_t n_ = 0;
};

}  // namespace whittle::mq
