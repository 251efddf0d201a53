/// \file
/// Looking at how faces meet; nothing is changed here but the direction of faces.
#include "files/manifold.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "whittle/surface/UnionFind.hh"

namespace whittle::files {
namespace {

using Triangles = std::vector<IndexedMesh::Triangle>;

constexpr std::uint32_t kNoCorner = static_cast<std::uint32_t>(-1);

/// For each side, named by its corner, the one of the neighbour where an edge has two faces; else `kNoCorner`.
std::vector<std::uint32_t> neighbours(const Triangles& triangles, std::size_t vertices) {
  std::vector<std::uint32_t> mates(3 * triangles.size(), kNoCorner);
  for_each_edge(measure::sides_by_edge(triangles, vertices),
                [&](const measure::Side* begin, const measure::Side* end) {
                  if (end - begin != 2) return;
                  mates[begin[0].corner] = begin[1].corner;
                  mates[begin[1].corner] = begin[0].corner;
                });
  return mates;
}

void turn(MeshFile& file, std::size_t face) {
  std::swap(file.mesh.triangles[face][1], file.mesh.triangles[face][2]);
  for (attributes::Attribute& attribute : file.attributes)
    if (!attribute.per_vertex()) std::swap(attribute.corners[face][1], attribute.corners[face][2]);
}

}  // namespace

std::vector<std::uint32_t> vertices_of_several_fans(const IndexedMesh& mesh,
                                                    const std::vector<measure::Side>& sides) {
  const Triangles& triangles = mesh.triangles;
  detail::UnionFind fans(3 * triangles.size());  // corners of one vertex, joined through edges
  std::vector<std::uint32_t> fan_count(mesh.points.size(), 0);
  for (const IndexedMesh::Triangle& triangle : triangles)
    for (const std::uint32_t vertex : triangle) ++fan_count[vertex];
  const auto corner_at = [&](const measure::Side& side, std::uint32_t vertex) {
    return measure::vertex_of(triangles, side.corner) == vertex ? side.corner
                                                                : measure::next_corner(side.corner);
  };
  for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    for (const measure::Side* side = begin + 1; side < end; ++side)
      for (const std::uint32_t vertex : {begin->low, begin->high})
        if (fans.join(corner_at(*begin, vertex), corner_at(*side, vertex))) --fan_count[vertex];
  });
  std::vector<std::uint32_t> several;
  for (std::uint32_t vertex = 0; vertex < fan_count.size(); ++vertex)
    if (fan_count[vertex] > 1) several.push_back(vertex);
  return several;
}

NonManifold count_nonmanifold(const IndexedMesh& mesh, const std::vector<measure::Side>& sides) {
  NonManifold found;
  for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    const auto faces = end - begin;
    const bool disagree = faces == 2 && rises(mesh.triangles, begin[0]) == rises(mesh.triangles, begin[1]);
    if (faces > 2 || disagree) ++found.edges;
  });
  found.vertices = vertices_of_several_fans(mesh, sides).size();
  return found;
}

std::vector<std::uint32_t> first_alike(const Triangles& triangles, const std::vector<measure::Side>& sides) {
  std::vector<std::uint32_t> first(triangles.size());
  std::iota(first.begin(), first.end(), 0U);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> thirds;  // third vertex, face
  for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    if (end - begin < 2) return;
    thirds.clear();
    for (const measure::Side* side = begin; side < end; ++side) {
      // A face comes by at each of its edges; it is counted at the one between its two lowest vertices.
      const std::uint32_t third = measure::vertex_of(triangles, measure::opposite_corner(side->corner));
      if (third > side->high) thirds.emplace_back(third, side->corner / 3);
    }
    std::sort(thirds.begin(), thirds.end());
    for (std::size_t i = 1; i < thirds.size(); ++i)
      if (thirds[i].first == thirds[i - 1].first) first[thirds[i].second] = first[thirds[i - 1].second];
  });
  return first;
}

std::size_t orient(MeshFile& file) {
  const Triangles& triangles = file.mesh.triangles;
  const std::vector<std::uint32_t> mates = neighbours(triangles, file.mesh.points.size());
  // Two sides of one edge agree if they run against each other: if they start at different vertices.
  const auto agree = [&](std::uint32_t corner, std::uint32_t mate) {
    return measure::vertex_of(triangles, corner) != measure::vertex_of(triangles, mate);
  };
  std::vector<bool> seen(triangles.size(), false), turned(triangles.size(), false);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
    if (seen[seed]) continue;
    seen[seed] = true;
    piece.assign(1, seed);
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (std::uint32_t corner = 3 * piece[i]; corner < 3 * piece[i] + 3; ++corner) {
        const std::uint32_t mate = mates[corner];
        if (mate == kNoCorner || seen[mate / 3]) continue;
        seen[mate / 3] = true;
        turned[mate / 3] = turned[piece[i]] == agree(corner, mate);
        piece.push_back(mate / 3);
      }
    }
    const auto many = std::count_if(piece.begin(), piece.end(), [&](std::uint32_t f) { return turned[f]; });
    if (2 * static_cast<std::size_t>(many) > piece.size())
      for (const std::uint32_t face : piece) turned[face] = !turned[face];
  }
  std::size_t count = 0;
  for (std::size_t face = 0; face < turned.size(); ++face) {
    if (!turned[face]) continue;
    turn(file, face);
    ++count;
  }
  return count;
}

}  // namespace whittle::files
