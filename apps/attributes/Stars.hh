/// \file
/// Which faces are around a vertex, and which vertices became one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

/// A list of numbers for each of a range of numbers, in one array.
class Lists {
 public:
  Lists() = default;

  /// Number i goes to the list of `key(i)`, for each i below `n`, in ascending order.
  template <typename Key>
  Lists(std::size_t n_lists, std::size_t n, Key key) : first_(n_lists + 1, 0), items_(n) {
    for (std::size_t i = 0; i < n; ++i) ++first_[key(i) + 1];
    for (std::size_t l = 0; l < n_lists; ++l) first_[l + 1] += first_[l];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < n; ++i) items_[next[key(i)]++] = static_cast<std::uint32_t>(i);
  }

  std::pair<const std::uint32_t*, const std::uint32_t*> of(std::size_t list) const {
    return {items_.data() + first_[list], items_.data() + first_[list + 1]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> items_;
};

/// The vertices that became each vertex.
class Members {
 public:
  Members(const std::vector<std::uint32_t>& vertex_map, std::size_t n_after)
      : lists_(n_after, vertex_map.size(), [&](std::size_t v) { return vertex_map[v]; }) {}

  std::pair<const std::uint32_t*, const std::uint32_t*> of(std::uint32_t w) const { return lists_.of(w); }

 private:
  Lists lists_;
};

/// The faces around each vertex.
class Stars {
 public:
  Stars() = default;
  explicit Stars(const IndexedMesh& mesh)
      : lists_(mesh.points.size(), 3 * mesh.triangles.size(),
               [&](std::size_t i) { return mesh.triangles[i / 3][i % 3]; }) {}

  /// Of one vertex, ascending.
  std::vector<std::uint32_t> of(std::uint32_t v) const {
    const std::uint32_t* one = &v;
    return around({one, one + 1});
  }

  /// Of several vertices, each once, ascending.
  std::vector<std::uint32_t> around(std::pair<const std::uint32_t*, const std::uint32_t*> vertices) const {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t* v = vertices.first; v != vertices.second; ++v) {
      const auto [first, last] = lists_.of(*v);
      for (const std::uint32_t* corner = first; corner != last; ++corner) faces.push_back(*corner / 3);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

 private:
  Lists lists_;
};

}  // namespace whittle::attributes
