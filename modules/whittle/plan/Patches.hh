/// \file
/// What hangs together around vertices that become one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/surface/Lists.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::detail {

/// The faces around some vertices, in patches: those that share an edge at both of whose ends their wedges agree,
/// directly or through others. Seams separate patches; a slit has the same patch on both sides at its end.
class Patches {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// A face at an edge from a lower vertex to a higher one: which of `faces()`, and its corners there, 0..2.
  struct Side {
    std::uint32_t face, at_low, at_high;
  };
  /// An edge of two faces whose wedges differ; one of its ends at least is one of the vertices.
  struct Seam {
    std::uint32_t low, high;
    Side first, second;
  };

  /// \param wedges  of the same size; both must outlive this.
  Patches(const Triangles& triangles, const Triangles& wedges, std::size_t n_vertices)
      : triangles_(triangles),
        wedges_(wedges),
        stars_(n_vertices, 3 * triangles.size(), [&](std::size_t i) { return triangles[i / 3][i % 3]; }) {}

  /// Looks at these vertices, in ascending order.
  void gather(Lists::Range vertices);

  const std::vector<std::uint32_t>& faces() const { return faces_; }  ///< around the vertices, ascending
  const std::vector<Seam>& seams() const { return seams_; }           ///< at the vertices

  /// Which of `faces()` a face is. \pre it is one of them
  std::uint32_t place(std::uint32_t face) const {
    return static_cast<std::uint32_t>(std::lower_bound(faces_.begin(), faces_.end(), face) - faces_.begin());
  }
  /// The patch of the i-th of `faces()`: the least i of those in it.
  std::uint32_t patch(std::uint32_t i) { return patches_.root(i); }
  /// Makes the patches of two faces one.
  void join(std::uint32_t i, std::uint32_t j) { patches_.join(i, j); }

 private:
  struct Half {
    std::array<std::uint32_t, 2> edge, wedges;  // at the lower vertex and at the higher one
    Side side;
  };
  void gather_halves();

  const Triangles &triangles_, &wedges_;
  Lists stars_;
  std::vector<std::uint32_t> faces_;
  std::vector<Half> halves_;
  std::vector<Seam> seams_;
  UnionFind patches_ = UnionFind(0);
};

inline void Patches::gather_halves() {
  halves_.clear();
  for (std::uint32_t i = 0; i < faces_.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto &t = triangles_[faces_[i]], &w = wedges_[faces_[i]];
      std::uint32_t low = k, high = (k + 1) % 3;
      if (t[high] < t[low]) std::swap(low, high);
      halves_.push_back({{t[low], t[high]}, {w[low], w[high]}, {i, low, high}});
    }
  std::sort(halves_.begin(), halves_.end(), [](const Half& a, const Half& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    return a.wedges != b.wedges ? a.wedges < b.wedges : a.side.face < b.side.face;
  });
}

inline void Patches::gather(Lists::Range vertices) {
  faces_.clear();
  for (const std::uint32_t* v = vertices.first; v != vertices.second; ++v) {
    const auto [first, last] = stars_.of(*v);
    for (const std::uint32_t* corner = first; corner != last; ++corner) faces_.push_back(*corner / 3);
  }
  std::sort(faces_.begin(), faces_.end());
  faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  patches_ = UnionFind(faces_.size());
  seams_.clear();
  gather_halves();
  const auto is_one = [&](std::uint32_t v) { return std::binary_search(vertices.first, vertices.second, v); };
  for (std::size_t h = 1; h < halves_.size(); ++h) {
    const Half &a = halves_[h - 1], &b = halves_[h];
    if (a.edge != b.edge) continue;
    if (a.wedges == b.wedges)
      patches_.join(a.side.face, b.side.face);
    else if (is_one(a.edge[0]) || is_one(a.edge[1]))
      seams_.push_back({a.edge[0], a.edge[1], a.side, b.side});
  }
}

}  // namespace whittle::detail
