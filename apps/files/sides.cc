#include "files/sides.hh"

#include <algorithm>
#include <limits>

#include "files/Fault.hh"

namespace whittle::files {

std::vector<Side> sides_by_edge(const std::vector<IndexedMesh::Triangle>& triangles, std::size_t vertices) {
  if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3)
    throw Fault("too many faces to look for what is not manifold");
  // Counted into a bucket for each lower vertex first: that takes a fraction of sorting them all.
  std::vector<std::size_t> begins(vertices + 1, 0);
  const auto for_each_side = [&](auto call) {
    for (std::size_t face = 0; face < triangles.size(); ++face) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangles[face][k], to = triangles[face][(k + 1) % 3];
        call(std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(3 * face + k));
      }
    }
  };
  for_each_side([&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++begins[low + 1]; });
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) begins[vertex + 1] += begins[vertex];

  std::vector<Side> sides(3 * triangles.size());
  std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
  for_each_side([&](std::uint32_t low, std::uint32_t high, std::uint32_t corner) {
    sides[next[low]++] = {low, high, corner};
  });
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begins[vertex]),
              sides.begin() + static_cast<std::ptrdiff_t>(begins[vertex + 1]),
              [](const Side& a, const Side& b) {
                return a.high != b.high ? a.high < b.high : a.corner < b.corner;
              });
  return sides;
}

}  // namespace whittle::files
