/// \file
/// The best request to a method that does not leave as many faces as requested.
#pragma once

#include <cstddef>
#include <functional>

namespace whittle::speed {

/// Looks for the request whose outcome comes nearest to `wanted`, by bisection between two bounds.
/// \param outcome  for a request how many faces are left; grows with the request, perhaps in steps.
/// \return the best request that was tried, the smaller one of two that are equally good.
/// \pre low <= high
std::size_t search_target(std::size_t wanted, std::size_t low, std::size_t high,
                          const std::function<std::size_t(std::size_t)>& outcome);

}  // namespace whittle::speed
