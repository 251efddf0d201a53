/// \file
/// Charts: what seams enclose.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/UnionFind.hh"

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
  struct Side {
    std::uint32_t low, high, at_low, at_high, face;
    bool same_edge(const Side& o) const {
      return low == o.low && high == o.high && at_low == o.at_low && at_high == o.at_high;
    }
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const auto& t = triangles[f];
      const auto& w = wedges[f];
      sides.push_back(t[k] < t[l] ? Side{t[k], t[l], w[k], w[l], f} : Side{t[l], t[k], w[l], w[k], f});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::array{a.low, a.high, a.at_low, a.at_high, a.face} <
           std::array{b.low, b.high, b.at_low, b.at_high, b.face};
  });
  detail::UnionFind pieces(triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].same_edge(sides[i - 1])) pieces.join(sides[i].face, sides[i - 1].face);

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
