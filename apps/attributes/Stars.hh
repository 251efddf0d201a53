/// \file
/// Which faces are around a vertex, and which vertices became one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Lists.hh"

namespace whittle::attributes {

/// The vertices that became each vertex.
class Members {
 public:
  Members(const std::vector<std::uint32_t>& vertex_map, std::size_t n_after)
      : lists_(n_after, vertex_map.size(), [&](std::size_t v) { return vertex_map[v]; }) {}

  std::pair<const std::uint32_t*, const std::uint32_t*> of(std::uint32_t w) const { return lists_.of(w); }

 private:
  detail::Lists lists_;
};

/// The faces around each vertex.
class Stars {
 public:
  Stars() = default;
  explicit Stars(const IndexedMesh& mesh)
      : lists_(detail::Lists::of_corners(mesh.triangles, mesh.points.size())) {}

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
  detail::Lists lists_;
};

}  // namespace whittle::attributes
