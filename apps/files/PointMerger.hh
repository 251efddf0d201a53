/// \file
/// One vertex for all corners at one place.
#pragma once

#include <cstdint>

#include "files/IndexTable.hh"
#include "files/MeshBuilder.hh"

namespace whittle::files {

/// Gives equal points the same vertex, in the order in which they come.
class PointMerger {
 public:
  explicit PointMerger(MeshBuilder& builder) : builder_(builder) {}

  std::uint32_t vertex(double x, double y, double z) {
    // Comparing as numbers makes -0.0 equal to 0.0; the hash must agree, and x + 0.0 turns -0.0 into 0.0.
    const Hash hash = Hash().add(x + 0.0).add(y + 0.0).add(z + 0.0);
    const IndexedMesh::Point point(x, y, z);
    const auto fresh = static_cast<std::uint32_t>(builder_.mesh().points.size());
    const std::uint32_t vertex = table_.find_or_add(
        hash, fresh, [&](std::uint32_t other) { return builder_.mesh().points[other] == point; });
    if (vertex == fresh)
      builder_.add_point(x, y, z);
    else
      ++builder_.report().merged_vertices;
    return vertex;
  }

 private:
  MeshBuilder& builder_;
  IndexTable table_;
};

}  // namespace whittle::files
