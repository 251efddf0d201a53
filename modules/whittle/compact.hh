/// \file
/// Garbage collection that keeps the order of what is left.
#pragma once

#include <OpenMesh/Core/Mesh/Status.hh>
#include <OpenMesh/Core/Utils/BaseProperty.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <cstddef>
#include <vector>

#include "whittle/openmesh/points_in_space.hh"

namespace whittle {

/// Where the elements of a mesh went: for each old index the new one, -1 for a deleted element.
struct Compaction {
  std::vector<int> vertices, edges, faces;
  int halfedge(int old) const { return edges[static_cast<std::size_t>(old) / 2] * 2 + old % 2; }
};

namespace detail {

/// Old indices of what is left, in order, and the map back.
template <typename IsDeleted>
std::vector<int> survivors(std::size_t n, std::vector<int>& map, IsDeleted is_deleted) {
  std::vector<int> left(n);
  map.resize(n);
  int count = 0;
  for (int i = 0; i < static_cast<int>(n); ++i) {
    const bool deleted = is_deleted(i);
    left[static_cast<std::size_t>(count)] = i;
    map[static_cast<std::size_t>(i)] = deleted ? -1 : count;
    count += !deleted;
  }
  left.resize(static_cast<std::size_t>(count));
  return left;
}

/// Moves the values of one property if it is of this type, without a virtual call for each. `width` values
/// belong together: two for half-edges, which move with their edge.
template <typename T>
bool move_values(OpenMesh::BaseProperty& property, const std::vector<int>& left, std::size_t width) {
  auto* typed = dynamic_cast<OpenMesh::PropertyT<T>*>(&property);
  if (!typed) return false;
  auto* to = typed->data_vector().data();
  const auto* values = to;
  for (const int from : left)
    for (std::size_t i = 0; i < width; ++i) *to++ = values[static_cast<std::size_t>(from) * width + i];
  return true;
}

/// Moves the values of all properties between two iterators. An element only moves towards the front, so none
/// is overwritten before it has been read.
template <typename... FastTypes, typename Iterator>
void move_properties(Iterator begin, Iterator end, const std::vector<int>& left, std::size_t width = 1) {
  for (Iterator p = begin; p != end; ++p) {
    if (!*p || (move_values<FastTypes>(**p, left, width) || ...)) continue;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const auto from = static_cast<std::size_t>(left[i]);
      for (std::size_t k = 0; from != i && k < width; ++k) (*p)->copy(from * width + k, i * width + k);
    }
  }
}

}  // namespace detail

/// Removes what is marked as deleted, in place of `mesh.garbage_collection()`, which moves the last elements
/// into the gaps. Here vertices, edges and faces keep their order, and all properties, the user's included,
/// stay with their elements. Without a status property of a kind, no element of that kind counts as deleted.
template <typename Mesh>
Compaction compact(Mesh& mesh) {
  detail::require_points_in_space<Mesh>();
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using EdgeHandle = typename Mesh::EdgeHandle;
  using FaceHandle = typename Mesh::FaceHandle;
  Compaction map;
  const bool vertex_status = mesh.has_vertex_status(), edge_status = mesh.has_edge_status(),
             face_status = mesh.has_face_status();
  const auto vertices = detail::survivors(mesh.n_vertices(), map.vertices, [&](int i) {
    return vertex_status && mesh.status(VertexHandle(i)).deleted();
  });
  const auto edges = detail::survivors(
      mesh.n_edges(), map.edges, [&](int i) { return edge_status && mesh.status(EdgeHandle(i)).deleted(); });
  const auto faces = detail::survivors(
      mesh.n_faces(), map.faces, [&](int i) { return face_status && mesh.status(FaceHandle(i)).deleted(); });

  // Connectivity: first every item to its new place, then its handles.
  const auto moved = [](const auto& handle, const std::vector<int>& to) {
    return handle.is_valid() ? to[static_cast<std::size_t>(handle.idx())] : -1;
  };
  const auto halfedge = [&](HalfedgeHandle h) {
    return HalfedgeHandle(h.is_valid() ? map.halfedge(h.idx()) : -1);
  };
  const int n_vertices = static_cast<int>(vertices.size()), n_edges = static_cast<int>(edges.size()),
            n_faces = static_cast<int>(faces.size());
  for (int i = 0; i < n_edges; ++i)
    mesh.edge(EdgeHandle(i)) = mesh.edge(EdgeHandle(edges[static_cast<std::size_t>(i)]));
  for (int i = 0; i < 2 * n_edges; ++i) {
    const HalfedgeHandle h(i);
    mesh.set_vertex_handle(h, VertexHandle(moved(mesh.to_vertex_handle(h), map.vertices)));
    mesh.set_face_handle(h, FaceHandle(moved(mesh.face_handle(h), map.faces)));
    // Sets the previous of the next one, too.
    mesh.set_next_halfedge_handle(h, halfedge(mesh.next_halfedge_handle(h)));
  }
  for (int i = 0; i < n_vertices; ++i) {
    const VertexHandle from(vertices[static_cast<std::size_t>(i)]);
    mesh.set_halfedge_handle(VertexHandle(i), halfedge(mesh.halfedge_handle(from)));
  }
  for (int i = 0; i < n_faces; ++i) {
    const FaceHandle from(faces[static_cast<std::size_t>(i)]);
    mesh.set_halfedge_handle(FaceHandle(i), halfedge(mesh.halfedge_handle(from)));
  }

  using Status = OpenMesh::Attributes::StatusInfo;
  detail::move_properties<typename Mesh::Point, typename Mesh::Normal, Status>(mesh.vprops_begin(),
                                                                               mesh.vprops_end(), vertices);
  detail::move_properties<Status>(mesh.eprops_begin(), mesh.eprops_end(), edges);
  detail::move_properties<typename Mesh::Normal, Status>(mesh.fprops_begin(), mesh.fprops_end(), faces);
  detail::move_properties<Status>(mesh.hprops_begin(), mesh.hprops_end(), edges, 2);
  mesh.resize(vertices.size(), edges.size(), faces.size());
  return map;
}

}  // namespace whittle
