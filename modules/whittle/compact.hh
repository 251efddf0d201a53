/// \file
/// Garbage collection that keeps the order of what is left.
#pragma once

#include <OpenMesh/Core/Mesh/Status.hh>
#include <OpenMesh/Core/Utils/BaseProperty.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <cstddef>
#include <vector>

namespace whittle {

/// Where the elements of a mesh went: for each old index the new one, -1 for a deleted element.
struct Compaction {
  std::vector<int> vertices, edges, faces;
  int halfedge(int old) const { return edges[static_cast<std::size_t>(old) / 2] * 2 + old % 2; }
};

namespace compaction {

/// Old indices of what is left, in order, and the map back.
template <typename IsDeleted>
std::vector<std::size_t> survivors(std::size_t n, std::vector<int>& map, IsDeleted is_deleted) {
  std::vector<std::size_t> left;
  left.reserve(n);
  map.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool deleted = is_deleted(static_cast<int>(i));
    map[i] = deleted ? -1 : static_cast<int>(left.size());
    if (!deleted) left.push_back(i);
  }
  return left;
}

/// Moves the values of one property if it is of this type, without a virtual call for each.
template <typename T>
bool move_values(OpenMesh::BaseProperty& property, const std::vector<std::size_t>& left) {
  auto* typed = dynamic_cast<OpenMesh::PropertyT<T>*>(&property);
  if (!typed) return false;
  auto& values = typed->data_vector();
  for (std::size_t i = 0; i < left.size(); ++i) values[i] = values[left[i]];
  return true;
}

/// Moves the values of all properties between two iterators. An element only moves towards the front, so none
/// is overwritten before it has been read.
template <typename... FastTypes, typename Iterator>
void move_properties(Iterator begin, Iterator end, const std::vector<std::size_t>& left) {
  for (Iterator p = begin; p != end; ++p) {
    if (!*p || (move_values<FastTypes>(**p, left) || ...)) continue;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (left[i] != i) (*p)->copy(left[i], i);
  }
}

}  // namespace compaction

/// Removes what is marked as deleted, in place of `mesh.garbage_collection()`, which moves the last elements
/// into the gaps. Here vertices, edges and faces keep their order, and all properties, the user's included,
/// stay with their elements. Without a status property of a kind, no element of that kind counts as deleted.
template <typename Mesh>
Compaction compact(Mesh& mesh) {
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using EdgeHandle = typename Mesh::EdgeHandle;
  using FaceHandle = typename Mesh::FaceHandle;
  Compaction map;
  const auto vertices = compaction::survivors(mesh.n_vertices(), map.vertices, [&](int i) {
    return mesh.has_vertex_status() && mesh.status(VertexHandle(i)).deleted();
  });
  const auto edges = compaction::survivors(mesh.n_edges(), map.edges, [&](int i) {
    return mesh.has_edge_status() && mesh.status(EdgeHandle(i)).deleted();
  });
  const auto faces = compaction::survivors(mesh.n_faces(), map.faces, [&](int i) {
    return mesh.has_face_status() && mesh.status(FaceHandle(i)).deleted();
  });

  // Connectivity: first every item to its new place, then its handles.
  const auto moved = [](const auto& handle, const std::vector<int>& to) {
    return handle.is_valid() ? to[static_cast<std::size_t>(handle.idx())] : -1;
  };
  const auto halfedge = [&](HalfedgeHandle h) {
    return HalfedgeHandle(h.is_valid() ? map.halfedge(h.idx()) : -1);
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    mesh.edge(EdgeHandle(static_cast<int>(i))) = mesh.edge(EdgeHandle(static_cast<int>(edges[i])));
  for (std::size_t i = 0; i < 2 * edges.size(); ++i) {
    const HalfedgeHandle h(static_cast<int>(i));
    mesh.set_vertex_handle(h, VertexHandle(moved(mesh.to_vertex_handle(h), map.vertices)));
    mesh.set_face_handle(h, FaceHandle(moved(mesh.face_handle(h), map.faces)));
    mesh.set_next_halfedge_handle(
        h, halfedge(mesh.next_halfedge_handle(h)));  // sets the next one's previous, too
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    mesh.set_halfedge_handle(VertexHandle(static_cast<int>(i)),
                             halfedge(mesh.halfedge_handle(VertexHandle(static_cast<int>(vertices[i])))));
  for (std::size_t i = 0; i < faces.size(); ++i)
    mesh.set_halfedge_handle(FaceHandle(static_cast<int>(i)),
                             halfedge(mesh.halfedge_handle(FaceHandle(static_cast<int>(faces[i])))));

  using Status = OpenMesh::Attributes::StatusInfo;
  compaction::move_properties<typename Mesh::Point, typename Mesh::Normal, Status>(
      mesh.vprops_begin(), mesh.vprops_end(), vertices);
  compaction::move_properties<Status>(mesh.eprops_begin(), mesh.eprops_end(), edges);
  compaction::move_properties<typename Mesh::Normal, Status>(mesh.fprops_begin(), mesh.fprops_end(), faces);
  if (mesh.hprops_begin() != mesh.hprops_end()) {
    std::vector<std::size_t> halfedges;
    halfedges.reserve(2 * edges.size());
    for (const std::size_t e : edges) {
      halfedges.push_back(2 * e);
      halfedges.push_back(2 * e + 1);
    }
    compaction::move_properties<Status>(mesh.hprops_begin(), mesh.hprops_end(), halfedges);
  }
  mesh.resize(vertices.size(), edges.size(), faces.size());
  return map;
}

}  // namespace whittle
