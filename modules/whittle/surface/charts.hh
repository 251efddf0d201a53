/// \file
/// Charts: what seams enclose.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/surface/UnionFind.hh"
#include "whittle/surface/seams.hh"

namespace whittle {

/// The chart of each face, counted from 0 in the order of their first faces.
struct Charts {
  std::vector<std::uint32_t> of_face;
  std::size_t count = 0;
};

/// Faces are in one chart if they hang together through edges at both of whose ends their wedges agree.
/// \param wedges  as SurfaceExtras has them, for each triangle
inline Charts charts(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     const std::vector<std::array<std::uint32_t, 3>>& wedges) {
  std::vector<std::pair<detail::WedgedEdge, std::uint32_t>> sides;  // with their faces
  sides.reserve(3 * triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(detail::WedgedEdge(triangles[f], wedges[f], k), f);
  std::sort(sides.begin(), sides.end());
  detail::UnionFind pieces(triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].first == sides[i - 1].first) pieces.join(sides[i].second, sides[i - 1].second);

  Charts charts;
  charts.of_face.resize(triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    const std::uint32_t root = pieces.root(f);
    charts.of_face[f] = root == f ? static_cast<std::uint32_t>(charts.count++) : charts.of_face[root];
  }
  return charts;
}

/// How many charts have no face left. \param face_origin  for each face that is left, the face that it was.
inline std::size_t count_vanished(const Charts& charts, const std::vector<std::uint32_t>& face_origin) {
  std::vector<bool> is_left(charts.count, false);
  for (const std::uint32_t f : face_origin) is_left[charts.of_face[f]] = true;
  return static_cast<std::size_t>(std::count(is_left.begin(), is_left.end(), false));
}

}  // namespace whittle
