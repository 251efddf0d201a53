/// \file
/// How seams run from vertex to vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "whittle/surface/seams.hh"

namespace whittle::detail {

/// The seam edges at each vertex, and along which of them vertices may merge two at a time so that the seams keep
/// their shape: ends, crossings and the boundary stay, and a seam around a chart keeps three edges at least, so that
/// the chart keeps a face, however many pairs merge in a pass.
class SeamGraph {
 public:
  SeamGraph() = default;
  /// \param wedges  as SurfaceExtras has them, for each triangle
  SeamGraph(const std::vector<std::array<std::uint32_t, 3>>& triangles,
            const std::vector<std::array<std::uint32_t, 3>>& wedges, std::size_t n_vertices);

  bool empty() const { return edges_.empty(); }

  /// The vertices at the other ends of the seam edges at a vertex, ascending.
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
    std::vector<std::uint32_t> out;
    for (auto edge = first(v); edge != edges_.end() && edge->first == v; ++edge) out.push_back(edge->second);
    return out;
  }
  /// Whether a seam passes through a vertex and none ends or branches there.
  bool is_passed(std::uint32_t v) const { return count(v) == 2; }

  /// Whether `v` may vanish into `w` along a seam.
  bool may_remove(std::uint32_t v, std::uint32_t w) const;

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge>::const_iterator first(std::uint32_t v) const {
    return std::lower_bound(edges_.begin(), edges_.end(), Edge(v, 0));
  }
  std::size_t count(std::uint32_t v) const {
    std::size_t n = 0;
    for (auto edge = first(v); edge != edges_.end() && edge->first == v; ++edge) ++n;
    return n;
  }
  bool has(std::uint32_t v, std::uint32_t w) const {
    return std::binary_search(edges_.begin(), edges_.end(), Edge(v, w));
  }

  std::vector<Edge> edges_;  // both ways, ascending
};

inline SeamGraph::SeamGraph(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                            const std::vector<std::array<std::uint32_t, 3>>& wedges, std::size_t n_vertices) {
  const std::vector<bool> is_split = split_vertices(triangles, wedges, n_vertices);
  std::vector<WedgedEdge> sides;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (is_split[triangles[f][k]] || is_split[triangles[f][(k + 1) % 3]])
        sides.emplace_back(triangles[f], wedges[f], k);
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto &a = sides[i - 1], &b = sides[i];
    if (!a.same_vertices(b) || a == b) continue;
    edges_.emplace_back(a.low, a.high);
    edges_.emplace_back(a.high, a.low);
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

/// With u the vertex on the other side of v, the seam u-v-w becomes u-w. If there was a seam edge u-w, it would fold
/// onto that, and if there was u-x-w, another merge of the same pass might.
inline bool SeamGraph::may_remove(std::uint32_t v, std::uint32_t w) const {
  if (!is_passed(v) || !has(v, w)) return false;
  const auto at_v = first(v);
  const std::uint32_t u = at_v->second == w ? std::next(at_v)->second : at_v->second;
  if (has(u, w)) return false;
  if (count(u) == 1 && count(w) == 1) return false;  // the slit between two ends would close
  for (const std::uint32_t x : neighbours(u))
    if (x != v && has(x, w)) return false;
  return true;
}

}  // namespace whittle::detail
