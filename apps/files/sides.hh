/// \file
/// How the faces of a mesh meet at its edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

/// One side of a face: from one of its corners to the next.
struct Side {
  std::uint32_t low, high;  ///< the vertices of its edge
  std::uint32_t corner;     ///< where it starts: 3 * face + position in the face
};

/// The corner where the side that starts at a corner ends, and the one opposite of it.
/// \{
inline std::uint32_t next_corner(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
inline std::uint32_t opposite_corner(std::uint32_t corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}
/// \}

inline std::uint32_t vertex_of(const std::vector<IndexedMesh::Triangle>& triangles, std::uint32_t corner) {
  return triangles[corner / 3][corner % 3];
}

/// True if the side runs from its lower vertex to its higher one.
inline bool rises(const std::vector<IndexedMesh::Triangle>& triangles, const Side& side) {
  return vertex_of(triangles, side.corner) == side.low;
}

/// All sides; those of one edge come one after the other, in the order of the faces.
/// \throw Fault  more corners than 32-bit numbers can index
std::vector<Side> sides_by_edge(const std::vector<IndexedMesh::Triangle>& triangles, std::size_t vertices);

/// Calls with the begin and the end of the sides of each edge.
template <typename Call>
void for_each_edge(const std::vector<Side>& sides, Call call) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
      ++end;
    call(sides.data() + begin, sides.data() + end);
  }
}

}  // namespace whittle::files
