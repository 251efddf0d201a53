/// \file
/// How much memory a piece of work takes at its worst, counted block by block.
#pragma once

#include <cstdint>

namespace whittle::speed {

/// Counts what operator new allocates during its lifetime, in all threads, libraries included; what they take by
/// malloc directly is not seen. A block counts as large as the allocator made it. Linking this
/// file replaces operator new and delete of the whole program; while nothing is counted they only pass on.
/// \pre only one exists at a time
class MemoryCount {
 public:
  MemoryCount();
  ~MemoryCount();
  MemoryCount(const MemoryCount&) = delete;
  MemoryCount& operator=(const MemoryCount&) = delete;

  /// Bytes taken since the beginning and not given back. Blocks that are older and were given back count
  /// negative.
  std::int64_t live() const;
  /// The most that were live at once since the beginning or the last `restart_peak`.
  std::int64_t peak() const;
  void restart_peak();
};

}  // namespace whittle::speed
