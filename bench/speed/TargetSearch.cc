#include "speed/TargetSearch.hh"

namespace whittle::speed {

std::size_t search_target(std::size_t wanted, std::size_t low, std::size_t high,
                          const std::function<std::size_t(std::size_t)>& outcome) {
  const auto apart = [&](std::size_t faces) { return faces > wanted ? faces - wanted : wanted - faces; };
  std::size_t best = low, best_apart = ~std::size_t{0};
  while (low <= high) {
    const std::size_t request = low + (high - low) / 2, faces = outcome(request);
    if (apart(faces) < best_apart || (apart(faces) == best_apart && request < best)) {
      best = request;
      best_apart = apart(faces);
    }
    if (faces == wanted) break;
    if (faces < wanted) {
      low = request + 1;
    } else {
      if (request == low) break;
      high = request - 1;
    }
  }
  return best;
}

}  // namespace whittle::speed
