/// \file
/// Finding equal things among many.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace whittle::files {

/// Mixes the bits of several numbers into one.
class Hash {
 public:
  Hash& add(std::uint64_t bits) {
    state_ = (state_ ^ bits) * 0x9e3779b97f4a7c15U;
    state_ ^= state_ >> 32;
    return *this;
  }
  Hash& add(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return add(std::uint64_t{bits});
  }
  Hash& add(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return add(bits);
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(state_ ^ state_ >> 29); }

 private:
  std::uint64_t state_ = 0x243f6a8885a308d3U;
};

/// An open hash table of indices into something that the caller keeps. A node and a key for each would take
/// several times the file.
class IndexTable {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Makes room for so many things.
  void reserve(std::size_t things) {
    std::size_t slots = std::max<std::size_t>(1024, slots_.size());
    while (slots < 2 * (things + 1)) slots *= 2;
    if (slots > slots_.size()) grow_to(slots);
  }

  /// The index of what is equal, or `none`.
  template <typename Equal>
  std::uint32_t find(Hash hash, Equal equal) const {
    return slots_.empty() ? none : slots_[slot_of(hash.value(), equal)].index;
  }

  /// The index of what is equal to the new thing; else `fresh`, the new thing's own, which is kept.
  /// \param equal  called with an index: is that one equal to the new thing?
  template <typename Equal>
  std::uint32_t find_or_add(Hash hash, std::uint32_t fresh, Equal equal) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[slot_of(hash.value(), equal)];
    if (slot.index == none) {
      slot = {hash.value(), fresh};
      ++used_;
    }
    return slot.index;
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t index = none;
  };

  /// The slot of what is equal, or the free one where it belongs.
  template <typename Equal>
  std::size_t slot_of(std::uint32_t hash, Equal equal) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash & mask;
    while (slots_[at].index != none && !(slots_[at].hash == hash && equal(slots_[at].index)))
      at = (at + 1) & mask;
    return at;
  }

  void grow() { grow_to(slots_.empty() ? 1024 : 2 * slots_.size()); }

  void grow_to(std::size_t size) {
    std::vector<Slot> old(size);
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.index != none) slots_[slot_of(slot.hash, [](std::uint32_t) { return false; })] = slot;
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace whittle::files
