/// \file
/// Comparing pictures of the viewer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>

#include "render/Image.hh"

namespace viewing {

constexpr int kBelowCaptions = 70;

inline std::size_t colours(const whittle::render::Image& image) {
  std::set<std::array<std::uint8_t, 4>> seen;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) seen.insert(image.at(x, y));
  return seen.size();
}

/// Part of the pixels in columns [from, to) below the captions where two pictures differ clearly.
inline double difference(const whittle::render::Image& a, const whittle::render::Image& b, int from, int to) {
  std::size_t differ = 0, all = 0;
  for (int y = kBelowCaptions; y < a.height; ++y)
    for (int x = from; x < to; ++x, ++all) {
      const auto p = a.at(x, y), q = b.at(x, y);
      differ += std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) > 12;
    }
  return static_cast<double>(differ) / static_cast<double>(all);
}

}  // namespace viewing
