/// \file
/// Which vertices are on seams.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace whittle {
namespace detail {

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
  std::vector<std::array<std::uint32_t, 4>> sides;  // an edge's lower and higher vertex, and the wedges there
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const auto &t = triangles[f], &w = wedges[f];
      if (is_split[t[k]] == is_split[t[l]]) continue;
      sides.push_back(t[k] < t[l] ? std::array{t[k], t[l], w[k], w[l]} : std::array{t[l], t[k], w[l], w[k]});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<bool> out = is_split;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto &a = sides[i - 1], &b = sides[i];
    if (a[0] == b[0] && a[1] == b[1] && a != b) out[a[0]] = out[a[1]] = true;
  }
  return out;
}

}  // namespace whittle
