/// \file
/// Work over a range on several threads, with a result that does not depend on them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <vector>

#include "measure/Watch.hh"

namespace whittle::measure {

/// The work is cut into blocks of this size whatever the number of threads, and the blocks' results are put
/// together in order: so the result does not depend on the threads.
constexpr std::size_t kBlock = 2048;

/// Who works, and who watches.
struct Crew {
  unsigned threads;
  Watch& watch;
};

/// Calls `work` with the begin and end of each block of 0..count-1, on several threads.
/// \return the results in the blocks' order.
/// \throw Cancelled
template <typename Result>
std::vector<Result> in_blocks(std::size_t count, const Crew& crew,
                              const std::function<Result(std::size_t, std::size_t)>& work) {
  std::vector<Result> results((count + kBlock - 1) / kBlock);
  std::atomic<std::size_t> next{0};
  const auto take_blocks = [&] {
    for (std::size_t block; !crew.watch.stopped() && (block = next++) < results.size();) {
      const std::size_t begin = block * kBlock, end = std::min(count, begin + kBlock);
      results[block] = work(begin, end);
      if (!crew.watch.done(static_cast<double>(end - begin))) return;
    }
  };
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min<std::size_t>(crew.threads, results.size()); ++i) {
    others.push_back(std::async(std::launch::async, take_blocks));
  }
  take_blocks();
  for (auto& other : others) other.get();
  crew.watch.check();
  return results;
}

}  // namespace whittle::measure
