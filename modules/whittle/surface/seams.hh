/// \file
/// Which vertices are on seams.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace whittle {
namespace detail {

/// An edge of a triangle: its lower and its higher vertex, and the wedges there.
struct WedgedEdge {
  std::uint32_t low, high, at_low, at_high;

  /// The edge from corner `k` to the next one.
  WedgedEdge(const std::array<std::uint32_t, 3>& triangle, const std::array<std::uint32_t, 3>& wedges,
             std::size_t k) {
    std::size_t l = (k + 1) % 3;
    if (triangle[l] < triangle[k]) std::swap(k, l);
    low = triangle[k];
    high = triangle[l];
    at_low = wedges[k];
    at_high = wedges[l];
  }
  bool same_vertices(const WedgedEdge& o) const { return low == o.low && high == o.high; }
  bool operator==(const WedgedEdge& o) const {
    return same_vertices(o) && at_low == o.at_low && at_high == o.at_high;
  }
  bool operator<(const WedgedEdge& o) const {
    return std::tie(low, high, at_low, at_high) < std::tie(o.low, o.high, o.at_low, o.at_high);
  }
};

/// For each vertex whether its corners differ.
inline std::vector<bool> split_vertices(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                        const std::vector<std::array<std::uint32_t, 3>>& wedges,
                                        std::size_t n_vertices) {
  std::vector<bool> is_split(n_vertices, false), is_known(n_vertices, false);
  std::vector<std::uint32_t> last(n_vertices);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles[f][k];
      if (is_known[v] && last[v] != wedges[f][k]) is_split[v] = true;
      last[v] = wedges[f][k];
      is_known[v] = true;
    }
  return is_split;
}

}  // namespace detail

/// For each vertex whether it is on a seam: an end of an edge at either of whose ends the wedges of two faces differ.
/// \param wedges  as SurfaceExtras has them, for each triangle
inline std::vector<bool> on_seams(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                  const std::vector<std::array<std::uint32_t, 3>>& wedges,
                                  std::size_t n_vertices) {
  const std::vector<bool> is_split = detail::split_vertices(triangles, wedges, n_vertices);
  // The end of a slit is on a seam, too, though its corners agree.
  std::vector<detail::WedgedEdge> sides;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (is_split[triangles[f][k]] != is_split[triangles[f][(k + 1) % 3]])
        sides.emplace_back(triangles[f], wedges[f], k);
  std::sort(sides.begin(), sides.end());
  std::vector<bool> out = is_split;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto &a = sides[i - 1], &b = sides[i];
    if (a.same_vertices(b) && !(a == b)) out[a.low] = out[a.high] = true;
  }
  return out;
}

}  // namespace whittle
