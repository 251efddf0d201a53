/// \file
/// Which sides of triangles are at one edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace whittle::detail {

/// The sides of triangles with wedges in chains, one for each edge. Side 3 f + k goes from corner k of triangle f to the
/// next corner. In a chain, sides come in the order of their wedges at the lower vertex, at the higher one, and of their
/// faces; where two that follow one another have different wedges there is a seam.
class EdgeChains {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  static constexpr std::uint32_t kNone = 0xffffffffu;

  EdgeChains() = default;
  /// Without links yet.
  explicit EdgeChains(std::size_t n_triangles) : next_(3 * n_triangles, kNone), agrees_(next_.size(), 0) {}
  /// \param wedges  as SurfaceExtras has them, for each triangle
  EdgeChains(const Triangles& triangles, const Triangles& wedges, std::size_t n_vertices);

  std::size_t n_sides() const { return next_.size(); }
  /// The next side at the edge of a side; kNone after the last.
  std::uint32_t next(std::uint32_t side) const { return next_[side]; }
  /// Whether the next side has the same wedges. False after the last.
  bool agrees(std::uint32_t side) const { return agrees_[side] != 0; }

  /// Makes two sides a chain. \pre they are in order, and neither is in one
  void link(std::uint32_t first, std::uint32_t second, bool agrees) {
    next_[first] = second;
    agrees_[first] = agrees;
  }

 private:
  std::vector<std::uint32_t> next_;
  std::vector<std::uint8_t> agrees_;
};

inline EdgeChains::EdgeChains(const Triangles& triangles, const Triangles& wedges, std::size_t n_vertices)
    : EdgeChains(triangles.size()) {
  struct Side {
    std::uint32_t high, at_low, at_high, side;
    auto key() const { return std::tie(high, at_low, at_high, side); }
  };
  std::vector<std::size_t> first(n_vertices + 1, 0);  // of each lower vertex
  for (const auto& t : triangles) {
    ++first[std::min(t[0], t[1])];
    ++first[std::min(t[1], t[2])];
    ++first[std::min(t[2], t[0])];
  }
  std::size_t sum = 0;
  for (std::size_t& n : first) n = std::exchange(sum, sum + n);
  std::vector<Side> sides(3 * triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t low = k, high = k == 2 ? 0 : k + 1;
      if (triangles[f][high] < triangles[f][low]) std::swap(low, high);
      sides[first[triangles[f][low]]++] = {triangles[f][high], wedges[f][low], wedges[f][high], 3 * f + k};
    }
  // Filling has moved each start to the end of its vertex.
  for (std::size_t v = 0, begin = 0; v < n_vertices; begin = first[v++]) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin),
              sides.begin() + static_cast<std::ptrdiff_t>(first[v]),
              [](const Side& a, const Side& b) { return a.key() < b.key(); });
    for (std::size_t i = begin + 1; i < first[v]; ++i) {
      const Side &a = sides[i - 1], &b = sides[i];
      if (a.high == b.high) link(a.side, b.side, a.at_low == b.at_low && a.at_high == b.at_high);
    }
  }
}

}  // namespace whittle::detail
