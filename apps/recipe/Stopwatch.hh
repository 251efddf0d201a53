/// \file
#pragma once

#include <chrono>
#include <utility>

namespace whittle::recipe {

/// Wall-clock seconds since the last lap.
class Stopwatch {
 public:
  double lap() {
    const auto now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace whittle::recipe
