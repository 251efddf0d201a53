#include "measure/MeshFacts.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "measure/sides.hh"
#include "measure/triangle.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::measure {

namespace {

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
  const std::vector<Side> sides = sides_by_edge(mesh.triangles, mesh.points.size(), Faces::proper);
  detail::UnionFind pieces(mesh.triangles.size());    // faces joined through edges
  detail::UnionFind fans(3 * mesh.triangles.size());  // corners of one vertex joined through edges
  detail::UnionFind boundary(mesh.points.size());     // vertices joined through boundary edges
  std::vector<std::uint32_t> fan_count(mesh.points.size(), 0);
  std::vector<bool> used(mesh.points.size(), false);

  for (const Side& side : sides) {
    const std::uint32_t vertex = vertex_of(mesh.triangles, side.corner);
    ++fan_count[vertex];  // every corner a fan of its own, until it is joined with another
    used[vertex] = true;
  }
  const std::size_t proper_faces = sides.size() / 3;
  facts.components = proper_faces;

  const auto corner_at = [&](const Side& s, std::uint32_t vertex) {
    return (vertex == s.low) == rises(mesh.triangles, s) ? s.corner : next_corner(s.corner);
  };

  double length_sum = 0, shortest = std::numeric_limits<double>::infinity();
  std::size_t boundary_joins = 0;
  std::vector<bool> on_boundary(mesh.points.size(), false);
  for_each_edge(sides, [&](const Side* begin, const Side* end) {
    const Side& first = *begin;
    const auto faces = end - begin;

    ++facts.edges;
    const double length = (mesh.points[first.low] - mesh.points[first.high]).norm();
    length_sum += length;
    shortest = std::min(shortest, length);
    facts.max_edge = std::max(facts.max_edge, length);

    if (faces == 1) {
      ++facts.boundary_edges;
      if (boundary.join(first.low, first.high)) ++boundary_joins;
      on_boundary[first.low] = on_boundary[first.high] = true;
    } else if (faces > 2 || rises(mesh.triangles, first) == rises(mesh.triangles, begin[1])) {
      ++facts.nonmanifold_edges;
    }
    for (const Side* side = begin + 1; side < end; ++side) {
      if (pieces.join(first.face(), side->face())) --facts.components;
      for (const std::uint32_t vertex : {first.low, first.high}) {
        if (fans.join(corner_at(first, vertex), corner_at(*side, vertex))) --fan_count[vertex];
      }
    }
  });

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
