/// \file
/// Vertices that a mesh has several times at one place, as files and graphics cards have them along seams.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/UnionFind.hh"
#include "whittle/surface/errors.hh"

namespace whittle::detail {

/// The vertices that edges with one face end at, sorted by place; those without a place in space left out. At a vertex whose edges all have two faces each
/// neighbour comes as often after it as before it, so what the neighbours add and what they take away is 0.
/// \pre every index is in range
template <typename Real>
std::vector<std::uint32_t> open_vertices_by_place(const IndexedMeshT<Real>& mesh) {
  const auto mixed = [](std::uint32_t v) {
    const std::uint64_t bits = (v + std::uint64_t{1}) * 0x9e3779b97f4a7c15u;
    return (bits ^ bits >> 29) * 0xbf58476d1ce4e5b9u;
  };
  std::vector<std::uint64_t> balance(mesh.points.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint64_t at_a = mixed(a), at_b = mixed(b), at_c = mixed(c);
    balance[a] += at_b - at_c;
    balance[b] += at_c - at_a;
    balance[c] += at_a - at_b;
  }
  std::vector<std::uint32_t> open;
  for (std::uint32_t v = 0; v < balance.size(); ++v)
    if (balance[v] != 0 && mesh.points[v].allFinite()) open.push_back(v);
  std::sort(open.begin(), open.end(), [&](std::uint32_t v, std::uint32_t w) {
    const auto &p = mesh.points[v], &q = mesh.points[w];
    return std::tuple(p.x(), p.y(), p.z(), v) < std::tuple(q.x(), q.y(), q.z(), w);
  });
  return open;
}

/// Calls `visit(begin, end)` for the open vertices of each place where there are several.
template <typename Real, typename Visit>
void for_each_doubled_place(const IndexedMeshT<Real>& mesh, Visit visit) {
  const std::vector<std::uint32_t> open = open_vertices_by_place(mesh);
  for (auto begin = open.begin(), end = begin; begin != open.end(); begin = end) {
    end = std::find_if(begin, open.end(),
                       [&](std::uint32_t v) { return mesh.points[v] != mesh.points[*begin]; });
    if (end - begin > 1) visit(begin, end);
  }
}

/// How many vertices with open edges lie at exactly the place of another such.
template <typename Real>
std::size_t count_doubled(const IndexedMeshT<Real>& mesh) {
  std::size_t count = 0;
  for_each_doubled_place(mesh, [&](auto begin, auto end) { count += static_cast<std::size_t>(end - begin); });
  return count;
}

/// Finds which vertices at one place become one.
class DoubledVertices {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  template <typename Real>
  explicit DoubledVertices(const IndexedMeshT<Real>& mesh) : triangles_(mesh.triangles) {
    if (triangles_.size() > std::numeric_limits<std::uint32_t>::max() / 3)
      throw InvalidMesh("the mesh has more triangles than 32-bit numbers can index corners of");
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      for (const std::uint32_t v : triangles_[f])
        if (v >= mesh.points.size())
          throw InvalidMesh("triangle " + std::to_string(f) + " names vertex " + std::to_string(v) + " of " +
                            std::to_string(mesh.points.size()));
    place_.resize(mesh.points.size());
    for (std::uint32_t v = 0; v < place_.size(); ++v) place_[v] = v;
    is_doubled_.resize(place_.size(), false);
    for_each_doubled_place(mesh, [&](auto begin, auto end) {
      is_doubled_[*begin] = true;
      for (auto v = begin; v != end; ++v) place_[*v] = *begin;
    });
  }

  /// For each vertex the first of those that it becomes one with; itself if there are none.
  std::vector<std::uint32_t> roots() {
    gather_sides();
    for_each_edge([&](auto begin, auto end) { find_pair(begin, end); });
    std::vector<bool> is_apart(place_.size(), false);
    UnionFind joined = join(is_apart);
    while (has_crowded(joined, is_apart) || has_collapsed(joined, is_apart)) joined = join(is_apart);
    std::vector<std::uint32_t> roots(place_.size());
    for (std::uint32_t v = 0; v < roots.size(); ++v) roots[v] = joined.root(v);
    return roots;
  }

 private:
  /// A side of a face by the places of its ends, and by the vertices there.
  struct Side {
    std::uint32_t low, high, at_low, at_high, corner;
    bool rises;  ///< runs from the lower place to the higher one

    bool has_edge_of(const Side& o) const { return low == o.low && high == o.high; }
    bool has_vertices_of(const Side& o) const { return at_low == o.at_low && at_high == o.at_high; }
    bool operator<(const Side& o) const {
      return std::tie(low, high, at_low, at_high, corner) <
             std::tie(o.low, o.high, o.at_low, o.at_high, o.corner);
    }
  };
  using Sides = std::vector<Side>::const_iterator;

  void gather_sides() {
    for (std::uint32_t f = 0; f < triangles_.size(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t v = triangles_[f][k], w = triangles_[f][(k + 1) % 3];
        const std::uint32_t from = place_[v], to = place_[w];
        if (from == to && v != w) collapsing_.emplace_back(v, w);
        if (from == to || !is_doubled_[from] || !is_doubled_[to]) continue;
        const bool rises = from < to;
        sides_.push_back(
            {std::min(from, to), std::max(from, to), rises ? v : w, rises ? w : v, 3 * f + k, rises});
      }
    std::sort(sides_.begin(), sides_.end());
  }

  template <typename Visit>
  void for_each_edge(Visit visit) const {
    for (auto begin = sides_.begin(), end = begin; begin != sides_.end(); begin = end) {
      end = std::find_if(begin, sides_.end(), [&](const Side& side) { return !side.has_edge_of(*begin); });
      visit(begin, end);
    }
  }

  /// Of the sides at one edge, two that share their vertices with no other, if there are just two.
  void find_pair(Sides begin, Sides end) {
    std::array<const Side*, 2> open{};
    std::size_t n = 0;
    for (auto side = begin; side != end; ++side) {
      const bool is_alone = (side == begin || !side->has_vertices_of(*std::prev(side))) &&
                            (std::next(side) == end || !side->has_vertices_of(*std::next(side)));
      if (!is_alone) continue;
      if (n == 2) return;
      open[n++] = &*side;
    }
    if (n < 2 || open[0]->rises == open[1]->rises) return;
    const auto opposite = [&](const Side& side) {
      return place_[triangles_[side.corner / 3][(side.corner + 2) % 3]];
    };
    if (opposite(*open[0]) != opposite(*open[1])) pairs_.emplace_back(*open[0], *open[1]);
  }

  UnionFind join(const std::vector<bool>& is_apart) const {
    UnionFind joined(place_.size());
    for (const auto& [one, other] : pairs_) {
      if (is_apart[one.low] || is_apart[one.high]) continue;
      joined.join(one.at_low, other.at_low);
      joined.join(one.at_high, other.at_high);
    }
    return joined;
  }

  /// Finds edges that joining would give a third face, or a second one of the same direction: at an end of each, where
  /// vertices differ, none is to be joined. \return whether there are any
  bool has_crowded(UnionFind& joined, std::vector<bool>& is_apart) const {
    bool any = false;
    std::vector<std::tuple<std::uint32_t, std::uint32_t, const Side*>> at;  // the ends as they would be
    for_each_edge([&](Sides begin, Sides end) {
      at.clear();
      for (auto side = begin; side != end; ++side)
        at.emplace_back(joined.root(side->at_low), joined.root(side->at_high), &*side);
      std::sort(at.begin(), at.end());
      for (std::size_t i = 0, k = 0; i < at.size(); i = k) {
        const Side& first = *std::get<2>(at[i]);
        bool differs_low = false, differs_high = false;
        for (k = i; k < at.size() && std::get<0>(at[k]) == std::get<0>(at[i]) &&
                    std::get<1>(at[k]) == std::get<1>(at[i]);
             ++k) {
          differs_low |= std::get<2>(at[k])->at_low != first.at_low;
          differs_high |= std::get<2>(at[k])->at_high != first.at_high;
        }
        if (k - i == 1 || (k - i == 2 && first.rises != std::get<2>(at[i + 1])->rises)) continue;
        if (!differs_low && !differs_high) continue;  // so the mesh has it
        is_apart[differs_low ? first.low : first.high] = true;
        any = true;
      }
    });
    return any;
  }

  /// Finds faces that joining would leave without an area: their corners at one place are not to be joined.
  /// \return whether there are any
  bool has_collapsed(UnionFind& joined, std::vector<bool>& is_apart) const {
    bool any = false;
    for (const auto& [v, w] : collapsing_)
      if (joined.root(v) == joined.root(w)) is_apart[place_[v]] = any = true;
    return any;
  }

  const std::vector<Triangle>& triangles_;
  std::vector<std::uint32_t> place_;  // of each vertex: the first open one there
  std::vector<bool> is_doubled_;      // whether a place has several
  std::vector<Side> sides_;           // between such, sorted
  std::vector<std::pair<Side, Side>> pairs_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> collapsing_;  // corners of a face at one place
};

}  // namespace whittle::detail
