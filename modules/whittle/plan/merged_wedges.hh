/// \file
/// Wedges of a mesh whose vertices have merged: which corners still have one value.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "whittle/plan/Patches.hh"
#include "whittle/surface/Lists.hh"
#include "whittle/surface/UnionFind.hh"
#include "whittle/surface/seams.hh"

namespace whittle {

/// Triangles before and after vertices have merged, by whatever did it.
struct Merged {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  const Triangles& before;
  const Triangles& after;
  const std::vector<std::uint32_t>& vertex_map;   ///< for each vertex before, the vertex that it became
  const std::vector<std::uint32_t>& face_origin;  ///< for each face after, the face that it was
  std::size_t n_vertices;                         ///< after
};

namespace detail {

/// Numbers the patches at each vertex after, and then joins those of which two faces have the same at one end of an
/// edge and not at the other: a chart between them has vanished.
class WedgeMerger {
 public:
  WedgeMerger(const Merged& merged, const WedgedFaces& before)
      : merged_(merged),
        wedges_(before.wedges),
        members_(merged.n_vertices, merged.vertex_map.size(),
                 [&](std::size_t v) { return merged.vertex_map[v]; }),
        stars_(Lists::of_corners(merged.after, merged.n_vertices)),
        patches_(before),
        is_split_(split_vertices(before.triangles, before.wedges, merged.vertex_map.size())),
        may_join_(merged.n_vertices, false),
        out_(merged.after.size()) {}

  Merged::Triangles run() {
    for (std::uint32_t w = 0; w < merged_.n_vertices; ++w) {
      first_apart_.push_back(apart_.size());
      number(w);
    }
    first_apart_.push_back(apart_.size());
    join();
    return std::move(out_);
  }

 private:
  /// Numbers the corners at `w` by `key(face before, its corner there)`.
  template <typename Key>
  void number_by(std::uint32_t w, Key key) {
    known_.clear();
    const auto [first, last] = stars_.of(w);
    for (const std::uint32_t* corner = first; corner != last; ++corner) {
      const std::uint32_t f = *corner / 3, k = *corner % 3;
      const auto [found, is_new] = known_.emplace(key(merged_.face_origin[f], k), n_numbers_);
      n_numbers_ += is_new;
      out_[f][k] = found->second;
    }
  }

  void number_alike(std::uint32_t w) {
    const auto [first, last] = stars_.of(w);
    for (const std::uint32_t* corner = first; corner != last; ++corner)
      out_[*corner / 3][*corner % 3] = n_numbers_;
    n_numbers_ += first != last;
  }

  void number(std::uint32_t w) {
    const auto [first, last] = members_.of(w);
    const bool is_split = std::any_of(first, last, [&](std::uint32_t v) { return is_split_[v]; });
    if (!is_split) return number_alike(w);
    if (last - first == 1)
      return number_by(w, [&](std::uint32_t f, std::uint32_t k) { return wedges_[f][k]; });
    patches_.gather({first, last});
    number_by(w, [&](std::uint32_t f, std::uint32_t) { return patches_.patch(patches_.place(f)); });
    may_join_[w] = known_.size() > 1;
    for (const Patches::Seam& seam : patches_.seams()) {
      const auto a = known_.find(patches_.patch(seam.first.face)),
                 b = known_.find(patches_.patch(seam.second.face));
      if (a != known_.end() && b != known_.end() && a != b) apart_.emplace_back(a->second, b->second);
    }
  }

  bool are_apart(std::uint32_t w, std::uint32_t a, std::uint32_t b, UnionFind& joined) const {
    for (std::size_t i = first_apart_[w]; i < first_apart_[w + 1]; ++i) {
      const std::uint32_t x = joined.root(apart_[i].first), y = joined.root(apart_[i].second);
      if ((x == a && y == b) || (x == b && y == a)) return true;
    }
    return false;
  }

  void join() {
    std::vector<WedgedEdge> sides;  // with the numbers as wedges
    for (std::size_t f = 0; f < merged_.after.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        if (may_join_[merged_.after[f][k]] || may_join_[merged_.after[f][(k + 1) % 3]])
          sides.emplace_back(merged_.after[f], out_[f], k);
    if (sides.empty()) return;
    std::sort(sides.begin(), sides.end());
    UnionFind joined(n_numbers_);
    const auto join_at = [&](std::uint32_t w, std::uint32_t a, std::uint32_t b) {
      a = joined.root(a);
      b = joined.root(b);
      return may_join_[w] && !are_apart(w, a, b, joined) && joined.join(a, b);
    };
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (std::size_t i = 1; i < sides.size(); ++i) {
        const WedgedEdge &a = sides[i - 1], &b = sides[i];
        if (!a.same_vertices(b)) continue;
        const bool low = joined.root(a.at_low) == joined.root(b.at_low),
                   high = joined.root(a.at_high) == joined.root(b.at_high);
        if (low && !high) goes_on |= join_at(a.high, a.at_high, b.at_high);
        if (high && !low) goes_on |= join_at(a.low, a.at_low, b.at_low);
      }
    }
    for (auto& corners : out_)
      for (std::uint32_t& number : corners) number = joined.root(number);
  }

  const Merged& merged_;
  const Merged::Triangles& wedges_;
  Lists members_, stars_;
  Patches patches_;
  std::vector<bool> is_split_;  // of vertices before: their corners differ
  std::vector<bool> may_join_;  // of vertices after: several have become it, and it has several numbers
  std::vector<std::pair<std::uint32_t, std::uint32_t>> apart_;  // numbers with a seam between them
  std::vector<std::size_t> first_apart_;                        // of each vertex
  std::map<std::uint32_t, std::uint32_t> known_;                // the numbers at the current vertex
  std::uint32_t n_numbers_ = 0;
  Merged::Triangles out_;
};

}  // namespace detail

/// The wedges after a decimation, in other numbers than before. Corners of a vertex that has not merged differ where
/// they differed. Else they are the same if the faces that they were in hang together around the vertices that became
/// one; and if a chart between them has vanished, so that they agree at the other end of an edge that two such faces
/// now share.
inline Merged::Triangles merged_wedges(const Merged& merged, const Merged::Triangles& wedges) {
  const detail::WedgedFaces before(merged.before, wedges, merged.vertex_map.size());
  return detail::WedgeMerger(merged, before).run();
}

}  // namespace whittle
