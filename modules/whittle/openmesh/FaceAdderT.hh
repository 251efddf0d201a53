/// \file
/// Triangles for an OpenMesh mesh, in a time that does not depend on how many of them meet in a vertex.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "whittle/openmesh/find_halfedge.hh"

namespace whittle::detail {

/// Adds triangles to a mesh as OpenMesh's `add_face` does: takes and refuses the same, and makes the same half-edges in
/// the same order with the same links. OpenMesh searches the faces around a vertex for an edge and for the end of a
/// fan; this finds an edge from the end that has fewer, and remembers where fans end. It says nothing on `omerr()`.
///
/// A fan at v, faces that hang together across edges, lies between `first`, the open half-edge that leaves v beside its
/// first face, and `last`, the one that comes to v beside its last face. Several fans at v follow one another in the
/// order that the open half-edges are linked in.
template <typename Mesh>
class FaceAdderT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using FaceHandle = typename Mesh::FaceHandle;

  /// \pre the faces at the vertices of later triangles are this adder's own.
  explicit FaceAdderT(Mesh& mesh) : mesh_(mesh) {}

  /// \return an invalid handle where two vertices are the same, an edge would get a third face or two faces of one
  ///         orientation, or the fan around a vertex is closed or would close beside another one.
  FaceHandle add(const std::array<VertexHandle, 3>& vertex);

 private:
  /// The ends of fans that a half-edge without a face is.
  struct Ends {
    HalfedgeHandle first;  ///< of the fan whose last it is, at the vertex that it comes to
    HalfedgeHandle last;   ///< of the fan whose first it is, at the vertex that it leaves
  };

  static constexpr std::array<std::size_t, 3> kNext{1, 2, 0};

  /// Links two sides of a new face at the vertex between them, and what is around.
  void link(HalfedgeHandle in, bool in_is_new, HalfedgeHandle out, bool out_is_new);

  HalfedgeHandle opposite(HalfedgeHandle h) const { return mesh_.opposite_halfedge_handle(h); }
  HalfedgeHandle next(HalfedgeHandle h) const { return mesh_.next_halfedge_handle(h); }
  HalfedgeHandle previous(HalfedgeHandle h) const { return mesh_.prev_halfedge_handle(h); }
  bool has_face(HalfedgeHandle h) const { return h.is_valid() && mesh_.face_handle(h).is_valid(); }
  Ends& ends(HalfedgeHandle h) { return ends_[static_cast<std::size_t>(h.idx())]; }
  void set_fan(HalfedgeHandle first, HalfedgeHandle last) {
    ends(first).last = last;
    ends(last).first = first;
  }

  Mesh& mesh_;
  std::vector<Ends> ends_;
};

template <typename Mesh>
auto FaceAdderT<Mesh>::add(const std::array<VertexHandle, 3>& vertex) -> FaceHandle {
  if (vertex[0] == vertex[1] || vertex[1] == vertex[2] || vertex[2] == vertex[0]) return FaceHandle();
  std::array<HalfedgeHandle, 3> side;
  std::array<bool, 3> is_new{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (has_face(mesh_.halfedge_handle(vertex[i]))) return FaceHandle();
    side[i] = find_halfedge(mesh_, vertex[i], vertex[kNext[i]]);
    is_new[i] = !side[i].is_valid();
    if (has_face(side[i])) return FaceHandle();
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeHandle in = side[i], out = side[kNext[i]];
    const bool both_old = !is_new[i] && !is_new[kNext[i]];
    if (both_old && next(in) != out && ends(out).last == in) return FaceHandle();
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (is_new[i]) side[i] = mesh_.new_edge(vertex[i], vertex[kNext[i]]);
  ends_.resize(mesh_.n_halfedges());
  const FaceHandle face = mesh_.new_face();
  mesh_.set_halfedge_handle(face, side[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    link(side[i], is_new[i], side[kNext[i]], is_new[kNext[i]]);
    mesh_.set_face_handle(side[i], face);
  }
  return face;
}

template <typename Mesh>
void FaceAdderT<Mesh>::link(HalfedgeHandle in, bool in_is_new, HalfedgeHandle out, bool out_is_new) {
  const VertexHandle v = mesh_.to_vertex_handle(in);
  const HalfedgeHandle after = opposite(in), before = opposite(out);
  if (in_is_new && out_is_new) {  // a fan of its own
    const HalfedgeHandle first = mesh_.halfedge_handle(v);
    if (first.is_valid()) {
      mesh_.set_next_halfedge_handle(previous(first), after);
      mesh_.set_next_halfedge_handle(before, first);
    } else {
      mesh_.set_next_halfedge_handle(before, after);
      mesh_.set_halfedge_handle(v, after);
    }
    set_fan(after, before);
  } else if (in_is_new) {  // a fan begins one face earlier
    mesh_.set_next_halfedge_handle(previous(out), after);
    mesh_.set_halfedge_handle(v, after);
    set_fan(after, ends(out).last);
  } else if (out_is_new) {  // a fan ends one face later
    mesh_.set_halfedge_handle(v, next(in));
    mesh_.set_next_halfedge_handle(before, next(in));
    set_fan(ends(in).first, before);
  } else if (ends(out).last != in) {  // the gap between two fans is filled
    const HalfedgeHandle first = ends(in).first, last = ends(out).last;
    if (next(in) != out) {  // those between them go after both
      const HalfedgeHandle beyond = next(last);
      mesh_.set_next_halfedge_handle(last, next(in));
      mesh_.set_next_halfedge_handle(previous(out), beyond);
    }
    if (mesh_.halfedge_handle(v) == out) mesh_.set_halfedge_handle(v, next(last));
    set_fan(first, last);
  }
  mesh_.set_next_halfedge_handle(in, out);
}

}  // namespace whittle::detail
