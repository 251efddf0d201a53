/// \file
/// From an OpenMesh mesh to the flat arrays that planners work on, and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "whittle/openmesh/FaceAdderT.hh"
#include "whittle/openmesh/points_in_space.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

namespace detail {

/// Calls `visit(f, triangle)` for each face that is not deleted, until it returns false.
/// \return whether it never did
/// \throw InvalidMesh  a face is not a triangle.
template <typename Mesh, typename Visit>
bool for_each_triangle(const Mesh& mesh, Visit visit) {
  const bool has_status = mesh.has_face_status();
  for (std::size_t f = 0; f < mesh.n_faces(); ++f) {
    const typename Mesh::FaceHandle face(static_cast<int>(f));
    if (has_status && mesh.status(face).deleted()) continue;
    const auto first = mesh.halfedge_handle(face);
    auto h = first;
    typename IndexedMeshT<typename Mesh::Scalar>::Triangle triangle;
    for (std::uint32_t& corner : triangle) {
      corner = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
    if (h != first) throw InvalidMesh("face " + std::to_string(f) + " is not a triangle");
    if (!visit(f, triangle)) return false;
  }
  return true;
}

}  // namespace detail

/// The points and faces of an OpenMesh mesh. Vertices keep their indices, deleted ones included, so that a
/// plan can be looked up by handle; deleted faces are left out.
/// \throw InvalidMesh  a face is not a triangle.
template <typename Mesh>
IndexedMeshT<typename Mesh::Scalar> to_indexed(const Mesh& mesh) {
  detail::require_points_in_space<Mesh>();
  IndexedMeshT<typename Mesh::Scalar> out;
  out.points.reserve(mesh.n_vertices());
  out.triangles.reserve(mesh.n_faces());
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    const auto& p = mesh.point(typename Mesh::VertexHandle(static_cast<int>(v)));
    out.points.emplace_back(p[0], p[1], p[2]);
  }
  detail::for_each_triangle(mesh, [&](std::size_t, const auto& triangle) {
    out.triangles.push_back(triangle);
    return true;
  });
  return out;
}

/// Adds points and triangles to an OpenMesh mesh, as a rule an empty one.
/// \return how many triangles OpenMesh could not take: degenerate ones, and those that would make an edge or
///         a vertex non-manifold. What `bulk` makes of a manifold mesh has none of them.
template <typename Mesh>
std::size_t to_openmesh(const IndexedMeshT<typename Mesh::Scalar>& indexed, Mesh& mesh) {
  detail::require_points_in_space<Mesh>();
  using VertexHandle = typename Mesh::VertexHandle;
  const int first = static_cast<int>(mesh.n_vertices());
  mesh.reserve(mesh.n_vertices() + indexed.points.size(),
               mesh.n_edges() + indexed.triangles.size() * 3 / 2 + 16,
               mesh.n_faces() + indexed.triangles.size());
  for (const auto& p : indexed.points) mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2]));
  std::size_t refused = 0;
  detail::FaceAdderT<Mesh> faces(mesh);
  for (const auto& t : indexed.triangles) {
    const auto corner = [&](std::size_t i) { return VertexHandle(first + static_cast<int>(t[i])); };
    refused += !faces.add({corner(0), corner(1), corner(2)}).is_valid();
  }
  return refused;
}

}  // namespace whittle
