#include "speed/subdivide.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

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

/// A corner of a triangle with the edge that begins there, the lower index first.
struct Side {
  std::uint32_t low, high, corner;
  bool operator<(const Side& other) const { return low != other.low ? low < other.low : high < other.high; }
};

}  // namespace

Arrays subdivide(const Arrays& arrays) {
  constexpr float kScatter = 0.01f / 2;  // a vector in the cube is shorter than 2
  const auto n_corners = static_cast<std::uint32_t>(3 * arrays.triangles.size());
  std::vector<Side> sides;
  sides.reserve(n_corners);
  for (std::uint32_t corner = 0; corner < n_corners; ++corner) {
    const auto& t = arrays.triangles[corner / 3];
    const auto [low, high] = std::minmax(t[corner % 3], t[(corner + 1) % 3]);
    sides.push_back({low, high, corner});
  }
  std::sort(sides.begin(), sides.end());

  Arrays out;
  out.points = arrays.points;
  std::vector<std::uint32_t> middle(n_corners);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    if (i == 0 || sides[i - 1] < side) {
      const Arrays::Point &a = arrays.points[side.low], &b = arrays.points[side.high];
      out.points.push_back((a + b) / 2 + kScatter * (b - a).norm() * scatter(side.low, side.high));
    }
    middle[side.corner] = static_cast<std::uint32_t>(out.points.size() - 1);
  }

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
