/// \file
/// Cutting a mesh apart where it is not manifold.
///
/// Only what is joined across an edge shares a vertex afterwards: joining the corners of each vertex along
/// the edges that stay gives its fans, and every fan but the first gets a vertex of its own.
#include <algorithm>
#include <utility>

#include "files/manifold.hh"
#include "files/subset.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::files {
namespace {

using Triangles = std::vector<IndexedMesh::Triangle>;

constexpr std::uint32_t unmated = static_cast<std::uint32_t>(-1);

/// For each side, named by its corner, the one that it stays joined with, or `unmated`.
std::vector<std::uint32_t> pair_sides(const Triangles& triangles, std::size_t vertices) {
  std::vector<std::uint32_t> mates(3 * triangles.size(), unmated);
  std::vector<std::uint32_t> up, down;
  for_each_edge(measure::sides_by_edge(triangles, vertices),
                [&](const measure::Side* begin, const measure::Side* end) {
                  up.clear();
                  down.clear();
                  for (const measure::Side* side = begin; side < end; ++side)
                    (rises(triangles, *side) ? up : down).push_back(side->corner);
                  for (std::size_t i = 0; i < std::min(up.size(), down.size()); ++i) {
                    mates[up[i]] = down[i];
                    mates[down[i]] = up[i];
                  }
                });
  return mates;
}

struct Fans {
  Triangles triangles;                   ///< over the vertices and the copies
  std::vector<std::uint32_t> originals;  ///< of the copies, which come behind the vertices
};

Fans find_fans(const Triangles& triangles, std::size_t vertices, const std::vector<std::uint32_t>& mates) {
  detail::UnionFind corners(3 * triangles.size());
  for (std::uint32_t corner = 0; corner < mates.size(); ++corner) {
    if (mates[corner] == unmated) continue;
    corners.join(corner, measure::next_corner(mates[corner]));
    corners.join(measure::next_corner(corner), mates[corner]);
  }
  Fans fans{triangles, {}};
  std::vector<bool> taken(vertices, false);
  for (std::uint32_t corner = 0; corner < mates.size(); ++corner) {
    std::uint32_t& vertex = fans.triangles[corner / 3][corner % 3];
    const std::uint32_t first = corners.root(corner);  // the lowest of the fan, so it comes first
    if (first != corner) {
      vertex = measure::vertex_of(fans.triangles, first);
    } else if (taken[vertex]) {
      fans.originals.push_back(vertex);
      vertex = static_cast<std::uint32_t>(vertices + fans.originals.size() - 1);
    } else {
      taken[vertex] = true;
    }
  }
  return fans;
}

/// A slit that is one edge long leaves both of its sides between the same two fans. The later faces there
/// are parted from all their neighbours.
/// \return whether there were any
bool part_where_doubled(const Fans& fans, std::size_t vertices, std::vector<std::uint32_t>& mates) {
  bool any = false;
  const auto part = [&](std::uint32_t face) {
    any = true;
    for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
      const std::uint32_t mate = std::exchange(mates[corner], unmated);
      if (mate != unmated) mates[mate] = unmated;
    }
  };
  const std::size_t all = vertices + fans.originals.size();
  for_each_edge(measure::sides_by_edge(fans.triangles, all),
                [&](const measure::Side* begin, const measure::Side* end) {
                  bool seen[2] = {false, false};
                  for (const measure::Side* side = begin; side < end; ++side)
                    if (std::exchange(seen[rises(fans.triangles, *side) ? 1 : 0], true))
                      part(side->corner / 3);
                });
  return any;
}

}  // namespace

std::size_t cut(MeshFile& file) {
  const std::size_t vertices = file.mesh.points.size();
  std::vector<std::uint32_t> mates = pair_sides(file.mesh.triangles, vertices);
  Fans fans = find_fans(file.mesh.triangles, vertices, mates);
  while (part_where_doubled(fans, vertices, mates)) fans = find_fans(file.mesh.triangles, vertices, mates);
  file.mesh.triangles = std::move(fans.triangles);
  copy_vertices(file, fans.originals);
  return fans.originals.size();
}

}  // namespace whittle::files
