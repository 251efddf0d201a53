/// \file
/// What a plan is made for: a mesh as flat arrays, and whether it is still the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/openmesh/convert.hh"
#include "whittle/openmesh/describe.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::detail {

/// Points, faces and flags of an OpenMesh mesh at one time. Vertices keep their indices, deleted ones included, which
/// lie where a living one is, so that nothing depends on them; deleted faces are left out.
template <typename Mesh>
class SnapshotT {
 public:
  using Indexed = IndexedMeshT<typename Mesh::Scalar>;

  SnapshotT() = default;
  /// \throw InvalidMesh  a face is not a triangle.
  explicit SnapshotT(const Mesh& mesh) : indexed_(to_indexed(mesh)), flags_(user_flags(mesh)) {
    hide_deleted(mesh);
  }

  const Indexed& indexed() const { return indexed_; }
  const std::vector<std::uint8_t>& flags() const { return flags_; }  ///< what the user says of each vertex
  std::size_t n_deleted() const { return n_deleted_; }               ///< vertices

  /// `is_of` needs none.
  void drop_points() { indexed_.points = {}; }

  /// Whether a mesh has the same faces, and no further locked or feature vertices.
  bool is_of(const Mesh& mesh) const {
    if (flags_.size() != mesh.n_vertices()) return false;
    if (mesh.has_vertex_status())
      for (std::size_t v = 0; v < flags_.size(); ++v) {
        const auto& status = mesh.status(vertex(v));
        if ((status.locked() || status.feature()) && (flags_[v] & (kLocked | kFeature)) == 0) return false;
      }
    auto known = indexed_.triangles.begin();
    const bool same = for_each_triangle(mesh, [&](std::size_t, const auto& triangle) {
      return known != indexed_.triangles.end() && *known++ == triangle;
    });
    return same && known == indexed_.triangles.end();
  }

 private:
  static typename Mesh::VertexHandle vertex(std::size_t v) {
    return typename Mesh::VertexHandle(static_cast<int>(v));
  }

  void hide_deleted(const Mesh& mesh) {
    if (!mesh.has_vertex_status()) return;
    auto& points = indexed_.points;
    std::size_t living = 0;
    while (living < points.size() && mesh.status(vertex(living)).deleted()) ++living;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (!mesh.status(vertex(v)).deleted()) continue;
      ++n_deleted_;
      if (living < points.size())
        points[v] = points[living];
      else
        points[v].setZero();
    }
  }

  Indexed indexed_;
  std::vector<std::uint8_t> flags_;
  std::size_t n_deleted_ = 0;
};

}  // namespace whittle::detail
