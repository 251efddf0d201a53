/// \file
/// Vertices at exactly equal positions become one, so that a mesh that was cut along its seams hangs together again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "whittle/openmesh/join_openmesh.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/doubled.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// What `join_doubled` makes of plain arrays.
template <typename Real>
struct JoinedT {
  IndexedMeshT<Real> mesh;  ///< all triangles, and the vertices that are left, in their old order
  std::vector<std::uint32_t> vertex_map;  ///< for each vertex of the input the one that it became
  /// For each corner of each triangle the vertex of the input whose values it has; where those of several that became one
  /// are equal, the first of these. For `SurfaceExtras::wedges`
  std::vector<typename IndexedMeshT<Real>::Triangle> wedges;
  std::size_t joined = 0;  ///< vertices that became one with an earlier one
};

/// Joins vertices at exactly equal positions where two open edges lie at one place and run against each other. Graphics
/// cards and many files have a vertex for each texture coordinate or normal, so a surface is open along its seams, and a
/// decimation tears it there. Where three open edges or more meet, or two run in the same direction, they stay apart, and
/// so do vertices that only touch: what was manifold stays so, and no face vanishes.
///
/// <!-- test: header_join_doubled -->
/// \code
/// const auto joined = whittle::join_doubled(mesh, texture, 2);  // u and v of each vertex
/// whittle::SurfaceExtras extras;
/// extras.wedges = joined.wedges;
/// whittle::DecimateOptions options;
/// options.ratio = 0.1;
/// const auto small = whittle::decimate(joined.mesh, options, whittle::MemorylessQuadric(), extras);
/// \endcode
/// \param values    `n_values` for each vertex, one after the other: what differs between those that become one is a seam.
///                  Without any there are no seams.
/// \throw InvalidMesh       a triangle names a vertex that is not there.
/// \throw InvalidParameter  there are not so many values.
template <typename Real>
JoinedT<Real> join_doubled(const IndexedMeshT<Real>& mesh, const std::vector<float>& values = {},
                           std::size_t n_values = 0) {
  const std::size_t n = mesh.points.size();
  if (values.size() != n_values * n)
    throw InvalidParameter("join_doubled: there are " + std::to_string(values.size()) + " values for " +
                           std::to_string(n) + " vertices with " + std::to_string(n_values) + " each");
  const std::vector<std::uint32_t> roots = detail::DoubledVertices(mesh).roots();
  JoinedT<Real> out;
  out.vertex_map.resize(n);
  const auto value_of = [&](std::uint32_t v) {
    return values.begin() + static_cast<std::ptrdiff_t>(n_values * v);
  };
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> same = roots;    // of those that become one, the first with equal values
  std::vector<std::uint32_t> next(n, kNone);  // of such a first, the next
  for (std::uint32_t v = 0; v < n; ++v) {
    if (roots[v] == v) {
      out.vertex_map[v] = static_cast<std::uint32_t>(out.mesh.points.size());
      out.mesh.points.push_back(mesh.points[v]);
      continue;
    }
    out.vertex_map[v] = out.vertex_map[roots[v]];
    ++out.joined;
    while (!std::equal(value_of(v), value_of(v + 1), value_of(same[v]))) {
      if (next[same[v]] == kNone) next[same[v]] = v;
      same[v] = next[same[v]];
      if (same[v] == v) break;
    }
  }
  out.mesh.triangles.reserve(mesh.triangles.size());
  out.wedges.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    out.mesh.triangles.push_back({out.vertex_map[a], out.vertex_map[b], out.vertex_map[c]});
    out.wedges.push_back({same[a], same[b], same[c]});
  }
  return out;
}

/// The same for an OpenMesh triangle mesh, in place. Texture coordinates of vertices that differ where vertices become one
/// are put at the half-edges, whose property is requested for that where the mesh has none; half-edge texture coordinates
/// that it has already stay as they are. A vertex keeps the properties of the first that it was, a normal and a colour,
/// too; all other elements and the user's properties stay in their order. What was deleted before is removed.
/// \return how many vertices became one with an earlier one; with 0 nothing has changed.
/// \throw InvalidMesh  a face is not a triangle, or OpenMesh cannot take a vertex that closes while other faces touch it;
///                     the mesh is as it was.
template <typename Mesh, typename = typename Mesh::VertexHandle>
std::size_t join_doubled(Mesh& mesh) {
  static_assert(Mesh::is_trimesh(), "whittle works on triangle meshes");
  return detail::MeshJoinerT<Mesh>(mesh).run();
}

}  // namespace whittle
