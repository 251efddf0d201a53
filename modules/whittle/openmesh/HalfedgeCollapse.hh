/// \file
/// Whether a half-edge of an OpenMesh mesh may collapse, and the collapse itself, inline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/openmesh/find_halfedge.hh"

namespace whittle::detail {

/// The legality test and the collapse of OpenMesh's decimaters, for triangle meshes, without a call into
/// OpenMesh's core library, which as Debian ships it checks every handle and every property on the way. Both
/// do to the mesh just what OpenMesh does, down to the half-edge that each vertex and face points to, but for a
/// vertex of more than 64 edges and several fans, which may point to the open half-edge of another fan. The
/// mesh needs vertex, edge and face status, and its `tagged` bits are left alone.
///
///            vl
///          /    \          h goes from v0 to v1; v0, the faces on both sides and the edges
///      hp /  left \ hn     v0-vl and v0-vr vanish.
///        /    h    \       hn takes the place of the other half-edge of v0-vl,
///      v0 --------> v1     op takes that of v0-vr.
///        \    o    /
///      on \ right / op
///          \    /
///            vr
template <typename Mesh>
class HalfedgeCollapseT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using FaceHandle = typename Mesh::FaceHandle;

  explicit HalfedgeCollapseT(Mesh& mesh) : mesh_(mesh) {}

  /// Whether OpenMesh's `is_collapse_legal` allows it: neither end deleted, v0 neither locked nor a feature
  /// off the feature's edges; the link condition; the boundary neither pinched nor left; no two faces back to
  /// back.
  bool is_legal(HalfedgeHandle h);

  /// The half-edge from one vertex to another, invalid if there is none.
  HalfedgeHandle find(VertexHandle from, VertexHandle to) const {
    const HalfedgeHandle start = mesh_.halfedge_handle(from);
    HalfedgeHandle h = start;
    if (!start.is_valid()) return h;
    do
      if (mesh_.to_vertex_handle(h) == to) return h;
    while ((h = rotated(h)) != start);
    return HalfedgeHandle();
  }

  void collapse(HalfedgeHandle h);

 private:
  static constexpr std::size_t kMany =
      64;  // edges, of which a vertex with more is a hub: its neighbours ask instead
  HalfedgeHandle next(HalfedgeHandle h) const { return mesh_.next_halfedge_handle(h); }
  HalfedgeHandle opposite(HalfedgeHandle h) const { return mesh_.opposite_halfedge_handle(h); }
  HalfedgeHandle rotated(HalfedgeHandle h) const { return next(opposite(h)); }
  bool is_open(HalfedgeHandle h) const { return !mesh_.face_handle(h).is_valid(); }
  bool is_boundary(VertexHandle v) const {
    const HalfedgeHandle h = mesh_.halfedge_handle(v);
    return !h.is_valid() || is_open(h);
  }
  /// Whether the vertex that `h` points to has three edges: those of `h` and of the next one, and one that is
  /// reached from both. Needs no half-edge that is farther away.
  bool points_to_valence_3(HalfedgeHandle h) const {
    return rotated(next(h)) == opposite(mesh_.prev_halfedge_handle(opposite(h)));
  }
  bool rings_meet_elsewhere(VertexHandle v0, VertexHandle v1, VertexHandle vl, VertexHandle vr);
  bool rings_meet_at_hub(VertexHandle v0, VertexHandle v1, VertexHandle vl, VertexHandle vr) const;

  /// `kept` takes the place of the other half-edge of `vanishing`, after the face that both are in.
  void replace(HalfedgeHandle kept, HalfedgeHandle vanishing);
  void point_to(VertexHandle v, HalfedgeHandle h, HalfedgeHandle open);

  Mesh& mesh_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
};

template <typename Mesh>
bool HalfedgeCollapseT<Mesh>::is_legal(HalfedgeHandle h) {
  const HalfedgeHandle o = opposite(h);
  const VertexHandle v0 = mesh_.to_vertex_handle(o), v1 = mesh_.to_vertex_handle(h);
  const auto& status = mesh_.status(v0);
  const auto edge = mesh_.edge_handle(h);
  if (status.locked() || status.deleted() || mesh_.status(v1).deleted() || mesh_.status(edge).deleted())
    return false;
  if (status.feature() && !mesh_.status(edge).feature()) return false;

  const bool left = !is_open(h), right = !is_open(o);
  const HalfedgeHandle hn = next(h), on = next(o);
  VertexHandle vl, vr;
  if (left) {
    vl = mesh_.to_vertex_handle(hn);
    if (is_open(opposite(hn)) && is_open(opposite(next(hn)))) return false;
  }
  if (right) {
    vr = mesh_.to_vertex_handle(on);
    if (is_open(opposite(on)) && is_open(opposite(next(on)))) return false;
  }
  if (vl == vr) return false;
  if (is_boundary(v0) && (!is_boundary(v1) || (left && right))) return false;
  if (rotated(rotated(h)) == h) return false;  // only one face at v0
  if (rings_meet_elsewhere(v0, v1, vl, vr)) return false;
  return !(left && right && points_to_valence_3(hn) && points_to_valence_3(on) &&
           find_halfedge(mesh_, vl, vr).is_valid());
}

template <typename Mesh>
bool HalfedgeCollapseT<Mesh>::rings_meet_elsewhere(VertexHandle v0, VertexHandle v1, VertexHandle vl,
                                                   VertexHandle vr) {
  if (mark_.size() != mesh_.n_vertices() || stamp_ == 0xffffffffu) {
    mark_.assign(mesh_.n_vertices(), 0);
    stamp_ = 0;
  }
  ++stamp_;
  const auto mark = [&](VertexHandle v) -> std::uint32_t& {
    return mark_[static_cast<std::size_t>(v.idx())];
  };
  HalfedgeHandle start = mesh_.halfedge_handle(v1), h = start;
  std::size_t n = 0;
  do {
    if (++n > kMany) return rings_meet_at_hub(v0, v1, vl, vr);
    mark(mesh_.to_vertex_handle(h)) = stamp_;
  } while ((h = rotated(h)) != start);
  h = start = mesh_.halfedge_handle(v0);
  do {
    const VertexHandle v = mesh_.to_vertex_handle(h);
    if (mark(v) == stamp_ && v != vl && v != vr) return true;
  } while ((h = rotated(h)) != start);
  return false;
}

/// Goes around the end with fewer edges, and asks each of its neighbours.
template <typename Mesh>
bool HalfedgeCollapseT<Mesh>::rings_meet_at_hub(VertexHandle v0, VertexHandle v1, VertexHandle vl,
                                                VertexHandle vr) const {
  const HalfedgeHandle start_0 = mesh_.halfedge_handle(v0), start_1 = mesh_.halfedge_handle(v1);
  HalfedgeHandle h = start_0, o = start_1;
  do {
    h = rotated(h);
    o = rotated(o);
  } while (h != start_0 && o != start_1);
  const HalfedgeHandle start = h == start_0 ? start_0 : start_1;
  const VertexHandle far = h == start_0 ? v1 : v0;
  h = start;
  do {
    const VertexHandle v = mesh_.to_vertex_handle(h);
    if (v != far && v != vl && v != vr && find_halfedge(mesh_, v, far).is_valid()) return true;
  } while ((h = rotated(h)) != start);
  return false;
}

template <typename Mesh>
void HalfedgeCollapseT<Mesh>::replace(HalfedgeHandle kept, HalfedgeHandle vanishing) {
  const HalfedgeHandle outer = opposite(vanishing);
  const FaceHandle face = mesh_.face_handle(outer), vanished = mesh_.face_handle(kept);
  mesh_.set_next_halfedge_handle(kept, next(outer));
  mesh_.set_next_halfedge_handle(mesh_.prev_halfedge_handle(outer), kept);
  mesh_.set_face_handle(kept, face);
  if (face.is_valid() && mesh_.halfedge_handle(face) == outer) mesh_.set_halfedge_handle(face, kept);

  mesh_.set_halfedge_handle(vanished, HalfedgeHandle());
  mesh_.status(vanished).set_deleted(true);
  mesh_.status(mesh_.edge_handle(outer)).set_deleted(true);
  if (!mesh_.has_halfedge_status()) return;
  mesh_.status(vanishing).set_deleted(true);
  mesh_.status(outer).set_deleted(true);
}

/// Makes a vertex point to `h`, or on the boundary to the first open half-edge from there on. Of a hub `open` will do,
/// which is the same where all its faces are one fan.
template <typename Mesh>
void HalfedgeCollapseT<Mesh>::point_to(VertexHandle v, HalfedgeHandle h, HalfedgeHandle open) {
  if (!is_boundary(v)) return mesh_.set_halfedge_handle(v, h);
  HalfedgeHandle first = h;
  for (std::size_t n = 1; !is_open(first) && n < kMany; ++n) first = rotated(first);
  mesh_.set_halfedge_handle(v, is_open(first) ? first : open);
}

template <typename Mesh>
void HalfedgeCollapseT<Mesh>::collapse(HalfedgeHandle h) {
  const HalfedgeHandle o = opposite(h), hn = next(h), on = next(o);
  const HalfedgeHandle hp = mesh_.prev_halfedge_handle(h), op = mesh_.prev_halfedge_handle(o);
  const VertexHandle v0 = mesh_.to_vertex_handle(o), v1 = mesh_.to_vertex_handle(h);
  const bool left = !is_open(h), right = !is_open(o);

  HalfedgeHandle spoke = h;
  do mesh_.set_vertex_handle(opposite(spoke), v1);
  while ((spoke = rotated(spoke)) != h);
  mesh_.set_next_halfedge_handle(hp, hn);
  mesh_.set_next_halfedge_handle(op, on);
  mesh_.set_isolated(v0);
  mesh_.status(v0).set_deleted(true);
  mesh_.status(mesh_.edge_handle(h)).set_deleted(true);
  if (mesh_.has_halfedge_status()) {
    mesh_.status(h).set_deleted(true);
    mesh_.status(o).set_deleted(true);
  }

  if (left) replace(hn, hp);
  if (right) replace(op, on);
  const auto now = [&](VertexHandle v) { return mesh_.halfedge_handle(v); };
  if (left) point_to(mesh_.to_vertex_handle(hn), opposite(hn), now(mesh_.to_vertex_handle(hn)));
  if (right) point_to(mesh_.to_vertex_handle(opposite(op)), op, now(mesh_.to_vertex_handle(opposite(op))));
  point_to(v1, right ? opposite(op) : hn, right ? now(v1) : on);
}

}  // namespace whittle::detail
