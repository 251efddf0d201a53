#include "speed/subdivide.hh"

#include <array>
#include <cstdint>
#include <vector>

#include "measure/sides.hh"

namespace whittle::speed {
namespace {

/// A vector in [-1, 1]³ from two indices; the mixing is that of SplitMix64.
Arrays::Point scatter(std::uint64_t a, std::uint64_t b) {
  std::uint64_t state = a << 32 | b;
  Arrays::Point p;
  for (int i = 0; i < 3; ++i) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    p[i] = static_cast<float>(static_cast<double>(z >> 40) / static_cast<double>(1u << 23) - 1);
  }
  return p;
}

}  // namespace

Arrays subdivide(const Arrays& arrays) {
  constexpr float kScatter = 0.01f / 2;  // a vector in the cube is shorter than 2
  Arrays out;
  out.points = arrays.points;
  std::vector<std::uint32_t> middle(3 * arrays.triangles.size());  // of the side that starts at a corner
  for_each_edge(
      measure::sides_by_edge(arrays.triangles, arrays.points.size()),
      [&](const measure::Side* begin, const measure::Side* end) {
        const Arrays::Point &a = arrays.points[begin->low], &b = arrays.points[begin->high];
        for (const measure::Side* side = begin; side < end; ++side)
          middle[side->corner] = static_cast<std::uint32_t>(out.points.size());
        out.points.push_back((a + b) / 2 + kScatter * (b - a).norm() * scatter(begin->low, begin->high));
      });

  out.triangles.reserve(4 * arrays.triangles.size());
  for (std::uint32_t f = 0; f < arrays.triangles.size(); ++f) {
    const auto& t = arrays.triangles[f];
    const std::array<std::uint32_t, 3> m{middle[3 * f], middle[3 * f + 1], middle[3 * f + 2]};
    for (int i = 0; i < 3; ++i) out.triangles.push_back({t[i], m[i], m[(i + 2) % 3]});
    out.triangles.push_back(m);
  }
  return out;
}

}  // namespace whittle::speed
