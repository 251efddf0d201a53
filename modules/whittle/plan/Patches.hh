/// \file
/// What hangs together around vertices that become one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "whittle/surface/EdgeChains.hh"
#include "whittle/surface/Lists.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::detail {

/// Triangles with wedges, prepared for looks around their vertices.
struct WedgedFaces {
  using Triangles = EdgeChains::Triangles;

  const Triangles &triangles, &wedges;
  EdgeChains chains;
  Lists corners;  ///< of each vertex: corner k of triangle f is number 3 f + k

  /// Both arrays, of the same size, must outlive this. \param chains  of the same
  WedgedFaces(const Triangles& all, const Triangles& their_wedges, EdgeChains their_chains,
              std::size_t n_vertices)
      : triangles(all),
        wedges(their_wedges),
        chains(std::move(their_chains)),
        corners(Lists::of_corners(all, n_vertices)) {}
  WedgedFaces(const Triangles& all, const Triangles& their_wedges, std::size_t n_vertices)
      : WedgedFaces(all, their_wedges, EdgeChains(all, their_wedges, n_vertices), n_vertices) {}
};

/// The faces around some vertices, in patches: those that share an edge at both of whose ends their wedges agree,
/// directly or through others. Seams separate patches; a slit has the same patch on both sides at its end.
class Patches {
 public:
  /// A face at an edge from a lower vertex to a higher one: which of `faces()`, and its corners there, 0..2.
  struct Side {
    std::uint32_t face, at_low, at_high;
  };
  /// An edge of two faces whose wedges differ; one of its ends at least is one of the vertices.
  struct Seam {
    std::uint32_t low, high;
    Side first, second;
  };

  /// The input must outlive this.
  explicit Patches(const WedgedFaces& input) : input_(input), place_(input.triangles.size(), 0) {}

  /// Looks at these vertices, in ascending order.
  void gather(Lists::Range vertices);

  const std::vector<std::uint32_t>& faces() const { return faces_; }  ///< around the vertices, ascending
  const std::vector<Seam>& seams() const { return seams_; }           ///< at the vertices

  /// Which of `faces()` a face is. \pre it is one of them
  std::uint32_t place(std::uint32_t face) const { return place_[face]; }
  /// The patch of the i-th of `faces()`: the least i of those in it.
  std::uint32_t patch(std::uint32_t i) { return patches_.root(i); }
  /// Makes the patches of two faces one.
  void join(std::uint32_t i, std::uint32_t j) { patches_.join(i, j); }

 private:
  bool has(std::uint32_t face) const { return place_[face] < faces_.size() && faces_[place_[face]] == face; }
  /// The corners of a side of the i-th face, at the lower vertex and at the higher one.
  Side side(std::uint32_t i, std::uint32_t k) const {
    const auto& t = input_.triangles[faces_[i]];
    const std::uint32_t l = k == 2 ? 0 : k + 1;
    return t[l] < t[k] ? Side{i, l, k} : Side{i, k, l};
  }
  std::uint32_t vertex(const Side& side, std::uint32_t corner) const {
    return input_.triangles[faces_[side.face]][corner];
  }
  std::uint32_t wedge(const Side& side, std::uint32_t corner) const {
    return input_.wedges[faces_[side.face]][corner];
  }
  void gather_faces(Lists::Range vertices);
  void sort_seams();

  const WedgedFaces& input_;
  std::vector<std::uint32_t> place_;  // of each face, if it is one of those
  std::vector<std::uint32_t> faces_;
  std::vector<Seam> seams_;
  UnionFind patches_ = UnionFind(0);
};

inline void Patches::gather_faces(Lists::Range vertices) {
  faces_.clear();
  for (const std::uint32_t* v = vertices.first; v != vertices.second; ++v) {
    const auto [first, last] = input_.corners.of(*v);
    for (const std::uint32_t* corner = first; corner != last; ++corner) {
      const std::uint32_t face = *corner / 3;
      if (has(face)) continue;
      place_[face] = static_cast<std::uint32_t>(faces_.size());
      faces_.push_back(face);
    }
  }
  std::sort(faces_.begin(), faces_.end());
  for (std::uint32_t i = 0; i < faces_.size(); ++i) place_[faces_[i]] = i;
}

/// By their edges; those at one edge are in the order of its chain.
inline void Patches::sort_seams() {
  const auto key = [&](const Seam& s) {
    return std::tuple(s.low, s.high, wedge(s.first, s.first.at_low), wedge(s.first, s.first.at_high),
                      s.first.face);
  };
  std::sort(seams_.begin(), seams_.end(), [&](const Seam& a, const Seam& b) {
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : key(a) < key(b);
  });
}

inline void Patches::gather(Lists::Range vertices) {
  gather_faces(vertices);
  patches_.reset(faces_.size());
  seams_.clear();
  const auto is_one = [&](std::uint32_t v) { return std::binary_search(vertices.first, vertices.second, v); };
  for (std::uint32_t i = 0; i < faces_.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t at = 3 * faces_[i] + k;
      std::uint32_t next = input_.chains.next(at);
      if (next == EdgeChains::kNone) continue;
      bool agrees = input_.chains.agrees(at);
      while (next != EdgeChains::kNone && !has(next / 3)) {
        agrees = agrees && input_.chains.agrees(next);
        next = input_.chains.next(next);
      }
      if (next == EdgeChains::kNone) continue;
      const std::uint32_t j = place_[next / 3];
      if (agrees) {
        patches_.join(i, j);
        continue;
      }
      const Side first = side(i, k), second = side(j, next % 3);
      const std::uint32_t low = vertex(first, first.at_low), high = vertex(first, first.at_high);
      if (is_one(low) || is_one(high)) seams_.push_back({low, high, first, second});
    }
  sort_seams();
}

}  // namespace whittle::detail
