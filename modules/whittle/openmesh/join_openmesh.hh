/// \file
/// Joins vertices of an OpenMesh mesh, with all properties.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "whittle/compact.hh"
#include "whittle/openmesh/FaceAdderT.hh"
#include "whittle/openmesh/StatusesT.hh"
#include "whittle/openmesh/convert.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/doubled.hh"
#include "whittle/surface/errors.hh"

namespace whittle::detail {

/// Adds the joined mesh behind the mesh, copies the properties over, and removes what was before it.
template <typename Mesh>
class MeshJoinerT {
 public:
  explicit MeshJoinerT(Mesh& mesh) : mesh_(mesh) {}

  std::size_t run() {
    IndexedMeshT<typename Mesh::Scalar> indexed = to_indexed(mesh_);
    roots_ = DoubledVertices(indexed).roots();
    std::size_t joined = 0;
    for (std::uint32_t v = 0; v < roots_.size(); ++v) joined += roots_[v] != v;
    if (joined == 0) return 0;
    const StatusesT<Mesh> statuses(mesh_);
    n_vertices_ = mesh_.n_vertices();
    n_edges_ = mesh_.n_edges();
    n_faces_ = mesh_.n_faces();
    add_vertices();
    add_faces();
    move_texture();
    for (std::size_t i = 0; i < n_vertices_; ++i) mesh_.status(vertex(i)).set_deleted(true);
    for (std::size_t i = 0; i < n_edges_; ++i)
      mesh_.status(typename Mesh::EdgeHandle(static_cast<int>(i))).set_deleted(true);
    for (std::size_t i = 0; i < n_faces_; ++i) mesh_.status(face(i)).set_deleted(true);
    compact(mesh_);
    return joined;
  }

 private:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using FaceHandle = typename Mesh::FaceHandle;

  static VertexHandle vertex(std::size_t i) { return VertexHandle(static_cast<int>(i)); }
  static FaceHandle face(std::size_t i) { return FaceHandle(static_cast<int>(i)); }
  static std::size_t index(const OpenMesh::BaseHandle& handle) {
    return static_cast<std::size_t>(handle.idx());
  }

  template <typename Iterator, typename Handle>
  static void copy(Iterator begin, Iterator end, Handle from, Handle to) {
    for (Iterator p = begin; p != end; ++p)
      if (*p) (*p)->copy(index(from), index(to));
  }

  void add_vertices() {
    became_.resize(n_vertices_);
    for (std::size_t v = 0; v < n_vertices_; ++v) {
      if (roots_[v] != v || mesh_.status(vertex(v)).deleted()) continue;
      became_[v] = mesh_.new_vertex();
      copy(mesh_.vprops_begin(), mesh_.vprops_end(), vertex(v), became_[v]);
    }
  }

  VertexHandle joined(VertexHandle v) const { return became_[roots_[index(v)]]; }

  void add_faces() {
    FaceAdderT<Mesh> adder(mesh_);
    for (std::size_t f = 0; f < n_faces_; ++f) {
      if (mesh_.status(face(f)).deleted()) continue;
      std::array<VertexHandle, 3> corners;
      HalfedgeHandle h = mesh_.halfedge_handle(face(f));
      for (VertexHandle& corner : corners) {
        corner = joined(mesh_.to_vertex_handle(h));
        h = mesh_.next_halfedge_handle(h);
      }
      const FaceHandle added = adder.add(corners);
      if (!added.is_valid()) {
        mesh_.resize(n_vertices_, n_edges_, n_faces_);
        throw InvalidMesh(
            "join_doubled: face " + std::to_string(f) +
            " has a vertex that would close while other faces touch it, which OpenMesh cannot hold");
      }
      copy(mesh_.fprops_begin(), mesh_.fprops_end(), face(f), added);
      pairs_.push_back(pair_sides(face(f), added));
    }
    // An edge has the properties of the first that it was; what is open still, those of the open side.
    std::vector<bool> is_known(mesh_.n_edges(), false);
    for (const Sides& sides : pairs_)
      for (const auto& [old, now] : sides) {
        copy(mesh_.hprops_begin(), mesh_.hprops_end(), old, now);
        const HalfedgeHandle behind = mesh_.opposite_halfedge_handle(now);
        if (mesh_.is_boundary(behind))
          copy(mesh_.hprops_begin(), mesh_.hprops_end(), mesh_.opposite_halfedge_handle(old), behind);
        const auto edge = mesh_.edge_handle(now);
        if (!is_known[index(edge)])
          copy(mesh_.eprops_begin(), mesh_.eprops_end(), mesh_.edge_handle(old), edge);
        is_known[index(edge)] = true;
      }
  }

  /// A half-edge of the mesh before, and what it is afterwards; of each face.
  using Sides = std::array<std::array<HalfedgeHandle, 2>, 3>;

  Sides pair_sides(FaceHandle old_face, FaceHandle new_face) const {
    Sides sides;
    HalfedgeHandle old = mesh_.halfedge_handle(old_face), now = mesh_.halfedge_handle(new_face);
    while (mesh_.to_vertex_handle(now) != joined(mesh_.to_vertex_handle(old)))
      now = mesh_.next_halfedge_handle(now);
    for (auto& side : sides) {
      side = {old, now};
      old = mesh_.next_halfedge_handle(old);
      now = mesh_.next_halfedge_handle(now);
    }
    return sides;
  }

  /// Puts the texture coordinates of vertices at the half-edges.
  void move_texture() {
    if (mesh_.has_vertex_texcoords1D())
      move(
          mesh_.has_halfedge_texcoords1D(), [&] { mesh_.request_halfedge_texcoords1D(); },
          [&](auto handle) { return mesh_.texcoord1D(handle); },
          [&](auto handle, const auto& value) { mesh_.set_texcoord1D(handle, value); });
    if (mesh_.has_vertex_texcoords2D())
      move(
          mesh_.has_halfedge_texcoords2D(), [&] { mesh_.request_halfedge_texcoords2D(); },
          [&](auto handle) { return mesh_.texcoord2D(handle); },
          [&](auto handle, const auto& value) { mesh_.set_texcoord2D(handle, value); });
    if (mesh_.has_vertex_texcoords3D())
      move(
          mesh_.has_halfedge_texcoords3D(), [&] { mesh_.request_halfedge_texcoords3D(); },
          [&](auto handle) { return mesh_.texcoord3D(handle); },
          [&](auto handle, const auto& value) { mesh_.set_texcoord3D(handle, value); });
  }

  template <typename Request, typename Get, typename Set>
  void move(bool has_corners, Request request, Get get, Set set) {
    bool differs = false;
    for (std::size_t v = 0; v < n_vertices_; ++v) differs |= get(vertex(v)) != get(vertex(roots_[v]));
    if (has_corners || !differs) return;
    request();
    for (const Sides& sides : pairs_)
      for (const auto& [old, now] : sides) set(now, get(mesh_.to_vertex_handle(old)));
  }

  Mesh& mesh_;
  std::vector<std::uint32_t> roots_;  // of each vertex: the first of those that it becomes one with
  std::vector<VertexHandle> became_;  // of each of these
  std::vector<Sides> pairs_;          // of each face
  std::size_t n_vertices_ = 0, n_edges_ = 0, n_faces_ = 0;
};

}  // namespace whittle::detail
