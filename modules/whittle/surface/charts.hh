/// \file
/// Charts: what seams enclose.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/EdgeChains.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle {

/// The chart of each face, counted from 0 in the order of their first faces.
struct Charts {
  std::vector<std::uint32_t> of_face;
  std::size_t count = 0;
};

namespace detail {

/// \param is_face  whether a face counts; the others are in no chart
template <typename IsFace>
Charts charts(const EdgeChains& chains, IsFace is_face) {
  const std::size_t n_faces = chains.n_sides() / 3;
  UnionFind pieces(n_faces);
  for (std::uint32_t side = 0; side < chains.n_sides(); ++side)
    if (chains.agrees(side)) pieces.join(side / 3, chains.next(side) / 3);
  Charts charts;
  charts.of_face.resize(n_faces);
  for (std::uint32_t f = 0; f < n_faces; ++f) {
    const std::uint32_t root = pieces.root(f);
    charts.of_face[f] = root < f     ? charts.of_face[root]
                        : is_face(f) ? static_cast<std::uint32_t>(charts.count++)
                                     : EdgeChains::kNone;
  }
  return charts;
}

}  // namespace detail

/// Faces are in one chart if they hang together through edges at both of whose ends their wedges agree.
/// \param wedges  as SurfaceExtras has them, for each triangle
inline Charts charts(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     const std::vector<std::array<std::uint32_t, 3>>& wedges) {
  std::uint32_t n_vertices = 0;
  for (const auto& t : triangles) n_vertices = std::max({n_vertices, t[0] + 1, t[1] + 1, t[2] + 1});
  return detail::charts(detail::EdgeChains(triangles, wedges, n_vertices),
                        [](std::uint32_t) { return true; });
}

/// A chart by one of its vertices, and how many faces it has.
struct ChartSize {
  std::uint32_t vertex;
  std::size_t faces;
};

/// Of each chart. \param triangles  the vertices of each face
inline std::vector<ChartSize> chart_sizes(const Charts& charts,
                                          const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<ChartSize> sizes(charts.count, {0, 0});
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (const std::uint32_t chart = charts.of_face[f]; chart < charts.count) {
      sizes[chart].vertex = triangles[f][0];
      ++sizes[chart].faces;
    }
  return sizes;
}

/// How many charts have no face left. \param face_origin  for each face that is left, the face that it was.
inline std::size_t count_vanished(const Charts& charts, const std::vector<std::uint32_t>& face_origin) {
  std::vector<bool> is_left(charts.count, false);
  for (const std::uint32_t f : face_origin) is_left[charts.of_face[f]] = true;
  return static_cast<std::size_t>(std::count(is_left.begin(), is_left.end(), false));
}

}  // namespace whittle
