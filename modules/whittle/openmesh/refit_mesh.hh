/// \file
/// The refit of an OpenMesh mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/plan/execute.hh"
#include "whittle/refit/refit.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::detail {

/// Refits a mesh whose vertices have merged.
/// \param input       the mesh before that, by the same indices
/// \param vertex_map  for each vertex the one that it has become
/// \param moved       is called with each vertex that has moved
template <typename Mesh, typename Moved>
RefitReport refit_mesh(Mesh& mesh, const IndexedMeshT<typename Mesh::Scalar>& input,
                       const std::vector<int>& vertex_map, const RefitOptions& options, Moved moved) {
  using Indexed = IndexedMeshT<typename Mesh::Scalar>;
  const auto index = [](int v) { return static_cast<std::size_t>(v); };
  Indexed left;
  std::vector<std::uint32_t> became(vertex_map.size()), origin;
  std::vector<int> vertices;  // of what is left
  for (int v = 0; index(v) < vertex_map.size(); ++v) {
    if (vertex_map[index(v)] != v) continue;
    const auto& p = mesh.point(typename Mesh::VertexHandle(v));
    became[index(v)] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(v);
    left.points.emplace_back(p[0], p[1], p[2]);
  }
  for (std::size_t v = 0; v < became.size(); ++v) became[v] = became[index(vertex_map[v])];
  append_left(input.triangles, became, left.triangles, origin);
  const std::vector<typename Indexed::Point> before = left.points;
  const RefitReport report = refit(input, left, became, origin, options);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (left.points[v] == before[v]) continue;
    const typename Mesh::VertexHandle handle(vertices[v]);
    auto p = mesh.point(handle);
    for (std::uint32_t i = 0; i < 3; ++i) p[i] = left.points[v][i];
    mesh.set_point(handle, p);
    moved(handle);
  }
  return report;
}

}  // namespace whittle::detail
