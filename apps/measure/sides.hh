/// \file
/// How the faces of a mesh meet at its edges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/errors.hh"

namespace whittle::measure {

/// One side of a face: from one of its corners to the next.
struct Side {
  std::uint32_t low, high;  ///< the vertices of its edge
  std::uint32_t corner;     ///< where it starts: 3 * face + position in the face

  std::uint32_t face() const { return corner / 3; }
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

inline bool has_vertex_twice(const IndexedMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Which faces have sides.
enum class Faces { all, proper };  ///< proper: but those with a vertex twice

/// The sides of the faces; those of one edge come one after the other, in the order of the faces.
/// \throw InvalidMesh  more corners than 32-bit numbers can index
inline std::vector<Side> sides_by_edge(const std::vector<IndexedMesh::Triangle>& triangles,
                                       std::size_t vertices, Faces faces = Faces::all) {
  if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3)
    throw InvalidMesh("the mesh has more faces than the 1431655765 whose edges can be numbered");
  // Counted into a bucket for each lower vertex first: that takes a fraction of sorting them all.
  std::vector<std::size_t> begins(vertices + 1, 0);
  const auto for_each_side = [&](auto call) {
    for (std::size_t face = 0; face < triangles.size(); ++face) {
      if (faces == Faces::proper && has_vertex_twice(triangles[face])) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangles[face][k], to = triangles[face][(k + 1) % 3];
        call(std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(3 * face + k));
      }
    }
  };
  for_each_side([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++begins[low + 1]; });
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) begins[vertex + 1] += begins[vertex];

  std::vector<Side> sides(begins[vertices]);
  std::vector<std::size_t>& ends = begins;  // which the buckets' begins become as they are filled
  for_each_side([&](std::uint32_t low, std::uint32_t high, std::uint32_t corner) {
    sides[ends[low]++] = {low, high, corner};
  });
  std::size_t begin = 0;
  for (std::size_t vertex = 0; vertex < vertices; begin = ends[vertex++])
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin),
              sides.begin() + static_cast<std::ptrdiff_t>(ends[vertex]), [](const Side& a, const Side& b) {
                return a.high != b.high ? a.high < b.high : a.corner < b.corner;
              });
  return sides;
}

/// Calls with the begin and the end of the sides of each edge.
template <typename Call>
void for_each_edge(const std::vector<Side>& sides, Call call) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
      ++end;
    call(sides.data() + begin, sides.data() + end);
  }
}

}  // namespace whittle::measure
