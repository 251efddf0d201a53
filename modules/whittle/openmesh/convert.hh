/// \file
/// From an OpenMesh mesh to the flat arrays that planners work on, and back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// The points and faces of an OpenMesh mesh. Vertices keep their indices, deleted ones included, so that a
/// plan can be looked up by handle; deleted faces are left out. \throw InvalidMesh  a face is not a triangle.
template <typename Mesh>
IndexedMeshT<typename Mesh::Scalar> to_indexed(const Mesh& mesh) {
  IndexedMeshT<typename Mesh::Scalar> out;
  out.points.reserve(mesh.n_vertices());
  out.triangles.reserve(mesh.n_faces());
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    const auto& p = mesh.point(typename Mesh::VertexHandle(static_cast<int>(v)));
    out.points.emplace_back(p[0], p[1], p[2]);
  }
  for (std::size_t f = 0; f < mesh.n_faces(); ++f) {
    const typename Mesh::FaceHandle face(static_cast<int>(f));
    if (mesh.has_face_status() && mesh.status(face).deleted()) continue;
    auto h = mesh.halfedge_handle(face);
    typename IndexedMeshT<typename Mesh::Scalar>::Triangle triangle;
    for (std::uint32_t& corner : triangle) {
      corner = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
    if (h != mesh.halfedge_handle(face))
      throw InvalidMesh("face " + std::to_string(f) + " is not a triangle");
    out.triangles.push_back(triangle);
  }
  return out;
}

/// Adds points and triangles to an OpenMesh mesh, as a rule an empty one.
/// \return how many triangles OpenMesh could not take: degenerate ones, and those that would make an edge or
/// a
///         vertex non-manifold. What `bulk` makes of a manifold mesh has none of them.
///         OpenMesh may say a word about them on its `omerr()`.
template <typename Mesh>
std::size_t to_openmesh(const IndexedMeshT<typename Mesh::Scalar>& indexed, Mesh& mesh) {
  using VertexHandle = typename Mesh::VertexHandle;
  const int first = static_cast<int>(mesh.n_vertices());
  mesh.reserve(mesh.n_vertices() + indexed.points.size(),
               mesh.n_edges() + indexed.triangles.size() * 3 / 2 + 16,
               mesh.n_faces() + indexed.triangles.size());
  for (const auto& p : indexed.points) mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2]));
  std::size_t refused = 0;
  for (const auto& t : indexed.triangles) {
    const auto corner = [&](std::size_t i) { return VertexHandle(first + static_cast<int>(t[i])); };
    const bool is_degenerate = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    refused += is_degenerate || !mesh.add_face(corner(0), corner(1), corner(2)).is_valid();
  }
  return refused;
}

/// Whether the faces around a vertex disagree about its texture coordinate. False for a mesh without
/// half-edge texture coordinates.
template <typename Mesh>
bool is_on_seam(const Mesh& mesh, typename Mesh::VertexHandle v) {
  const auto differs = [&](auto has, auto get) {
    if (!has) return false;
    typename Mesh::HalfedgeHandle first;
    for (auto h = mesh.cvih_iter(v); h.is_valid(); ++h) {
      if (mesh.is_boundary(*h)) continue;
      if (!first.is_valid()) first = *h;
      if (get(*h) != get(first)) return true;
    }
    return false;
  };
  return differs(mesh.has_halfedge_texcoords1D(), [&](auto h) { return mesh.texcoord1D(h); }) ||
         differs(mesh.has_halfedge_texcoords2D(), [&](auto h) { return mesh.texcoord2D(h); }) ||
         differs(mesh.has_halfedge_texcoords3D(), [&](auto h) { return mesh.texcoord3D(h); });
}

/// What the user said of each vertex: locked, feature; and whether its half-edge texture coordinates differ.
template <typename Mesh>
std::vector<std::uint8_t> user_flags(const Mesh& mesh) {
  std::vector<std::uint8_t> flags(mesh.n_vertices(), 0);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const typename Mesh::VertexHandle v(static_cast<int>(i));
    if (mesh.has_vertex_status()) {
      const auto& status = mesh.status(v);
      if (status.deleted()) continue;
      if (status.locked()) flags[i] |= kLocked;
      if (status.feature()) flags[i] |= kFeature;
    }
    if (is_on_seam(mesh, v)) flags[i] |= kSeam;
  }
  return flags;
}

}  // namespace whittle
