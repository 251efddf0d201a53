#include "measure/MeshFacts.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "measure/UnionFind.hh"
#include "measure/triangle.hh"

namespace whittle::measure {

namespace {

/// One side of a face: the undirected edge, and the corner of the face that it starts from.
struct Side {
  std::uint32_t low, high;  // the edge's vertices
  std::uint32_t corner;     // 3 * face + position in the face

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
  bool operator<(const Side& other) const {
    if (low != other.low) return low < other.low;
    if (high != other.high) return high < other.high;
    return corner < other.corner;
  }
};

bool has_vertex_twice(const IndexedMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// The sides of all faces but those with a vertex twice; those of one edge come one after the other.
std::vector<Side> sorted_sides(const IndexedMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const auto& triangle = mesh.triangles[face];
    if (has_vertex_twice(triangle)) continue;
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(3 * face + i)});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::size_t count_duplicates(const IndexedMesh& mesh) {
  std::vector<IndexedMesh::Triangle> faces;
  faces.reserve(mesh.triangles.size());
  for (auto triangle : mesh.triangles) {
    if (has_vertex_twice(triangle)) continue;
    std::sort(triangle.begin(), triangle.end());
    faces.push_back(triangle);
  }
  std::sort(faces.begin(), faces.end());
  const auto distinct = std::unique(faces.begin(), faces.end());
  return static_cast<std::size_t>(faces.end() - distinct);
}

void add_sizes(const IndexedMesh& mesh, MeshFacts& facts) {
  if (mesh.points.empty()) return;
  facts.box_min = facts.box_max = mesh.points.front();
  for (const auto& point : mesh.points) {
    facts.box_min = facts.box_min.cwiseMin(point);
    facts.box_max = facts.box_max.cwiseMax(point);
  }
  facts.diagonal = (facts.box_max - facts.box_min).norm();

  // Volumes against the centre of the box, not against the origin: far from the origin they would cancel out.
  const Eigen::Vector3d centre = 0.5 * (facts.box_min + facts.box_max);
  for (const auto& triangle : mesh.triangles) {
    const Corners face = corners(mesh, triangle);
    if (has_vertex_twice(triangle) || face.degenerate()) ++facts.degenerate_faces;
    facts.area += face.area();
    facts.volume += (face.a - centre).dot(face.normal()) / 6;
  }
}

/// Walks over the edges, that is the runs of equal sides, and counts what depends on how faces meet.
void add_connections(const IndexedMesh& mesh, MeshFacts& facts) {
  const std::vector<Side> sides = sorted_sides(mesh);
  UnionFind pieces(mesh.triangles.size());    // faces joined through edges
  UnionFind fans(3 * mesh.triangles.size());  // corners of one vertex joined through edges
  UnionFind boundary(mesh.points.size());     // vertices joined through boundary edges
  std::vector<std::uint32_t> fan_count(mesh.points.size(), 0);
  std::vector<bool> used(mesh.points.size(), false);

  for (const Side& side : sides) {
    const std::uint32_t vertex = mesh.triangles[side.corner / 3][side.corner % 3];
    ++fan_count[vertex];  // every corner a fan of its own, until it is joined with another
    used[vertex] = true;
  }
  const std::size_t proper_faces = sides.size() / 3;
  facts.components = proper_faces;

  const auto starts_low = [&](const Side& s) { return mesh.triangles[s.corner / 3][s.corner % 3] == s.low; };
  const auto corner_at = [&](const Side& s, std::uint32_t vertex) {
    const std::uint32_t next = s.corner % 3 == 2 ? s.corner - 2 : s.corner + 1;
    return (vertex == s.low) == starts_low(s) ? s.corner : next;
  };

  double length_sum = 0, shortest = std::numeric_limits<double>::max();
  std::size_t boundary_joins = 0;
  std::vector<bool> on_boundary(mesh.points.size(), false);
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
    const Side& first = sides[begin];
    for (end = begin + 1; end < sides.size() && sides[end].same_edge(first);) ++end;
    const std::size_t faces = end - begin;

    ++facts.edges;
    const double length = (mesh.points[first.low] - mesh.points[first.high]).norm();
    length_sum += length;
    shortest = std::min(shortest, length);
    facts.max_edge = std::max(facts.max_edge, length);

    if (faces == 1) {
      ++facts.boundary_edges;
      if (boundary.join(first.low, first.high)) ++boundary_joins;
      on_boundary[first.low] = on_boundary[first.high] = true;
    } else if (faces > 2 || starts_low(first) == starts_low(sides[begin + 1])) {
      ++facts.nonmanifold_edges;
    }
    for (std::size_t i = begin + 1; i < end; ++i) {
      if (pieces.join(first.corner / 3, sides[i].corner / 3)) --facts.components;
      for (const std::uint32_t vertex : {first.low, first.high}) {
        if (fans.join(corner_at(first, vertex), corner_at(sides[i], vertex))) --fan_count[vertex];
      }
    }
  }

  // A chain over n vertices takes n - 1 successful joins.
  facts.boundary_loops =
      static_cast<std::size_t>(std::count(on_boundary.begin(), on_boundary.end(), true)) - boundary_joins;
  facts.isolated_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  facts.nonmanifold_vertices = static_cast<std::size_t>(
      std::count_if(fan_count.begin(), fan_count.end(), [](std::uint32_t n) { return n > 1; }));
  facts.euler_characteristic = static_cast<long>(facts.vertices - facts.isolated_vertices) -
                               static_cast<long>(facts.edges) + static_cast<long>(proper_faces);
  if (facts.edges > 0) {
    facts.mean_edge = length_sum / static_cast<double>(facts.edges);
    facts.min_edge = shortest;
  }
}

}  // namespace

MeshFacts facts(const IndexedMesh& mesh) {
  MeshFacts result;
  result.vertices = mesh.points.size();
  result.faces = mesh.triangles.size();
  result.duplicate_faces = count_duplicates(mesh);
  add_sizes(mesh, result);
  add_connections(mesh, result);
  return result;
}

}  // namespace whittle::measure
