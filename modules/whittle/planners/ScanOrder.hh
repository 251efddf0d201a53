/// \file
/// In which order a planner looks at triangles or vertices.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace whittle {

enum class ScanOrder {
  index,  ///< as they stand in the mesh: the paper's
  error   ///< the one whose merge adds the least error first, so that a target takes the cheapest merges
};

namespace detail {

/// Calls `visit(i)` for each i below `n` in the order that is asked for; equally cheap ones by index.
/// \param cost  of i on the input; HUGE_VAL where there is nothing to do. Only called for ScanOrder::error.
template <typename Cost, typename Visit>
void scan(std::uint32_t n, ScanOrder order, Cost cost, Visit visit) {
  if (order == ScanOrder::index) {
    for (std::uint32_t i = 0; i < n; ++i) visit(i);
    return;
  }
  std::vector<std::pair<double, std::uint32_t>> ranked;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double c = cost(i);
    if (c < HUGE_VAL) ranked.emplace_back(c, i);
  }
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [c, i] : ranked) visit(i);
}

}  // namespace detail

}  // namespace whittle
