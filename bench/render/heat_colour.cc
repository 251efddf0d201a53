#include "render/heat_colour.hh"

#include <algorithm>

namespace whittle::render {

Eigen::Vector3f heat_colour(double value) {
  static const Eigen::Vector3f stops[] = {{0.267f, 0.005f, 0.329f},
                                          {0.231f, 0.322f, 0.545f},
                                          {0.129f, 0.569f, 0.549f},
                                          {0.369f, 0.788f, 0.384f},
                                          {0.993f, 0.906f, 0.144f}};
  const double along = 4 * std::clamp(value, 0.0, 1.0);
  const int stop = std::min(static_cast<int>(along), 3);
  const auto part = static_cast<float>(along - stop);
  return (1 - part) * stops[stop] + part * stops[stop + 1];
}

}  // namespace whittle::render
