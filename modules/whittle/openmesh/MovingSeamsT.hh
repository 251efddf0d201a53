/// \file
/// The seams of half-edge texture coordinates while vertices merge along them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/openmesh/describe.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::detail {

/// Which edges of an OpenMesh mesh are seams, and what collapses make of them. The rules are those of mq
/// (`mq/seams.hh`): two vertices on seams merge along a seam edge only, or along the boundary where the chart between
/// them is a single face, and one inside a chart may merge into one on a seam.
template <typename Mesh>
class MovingSeamsT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using EdgeHandle = typename Mesh::EdgeHandle;

  /// From now on, the seams are those of the mesh's texture coordinates as they are.
  void take_snapshot(const Mesh& mesh);

  bool empty() const { return is_seam_.empty(); }  ///< whether there was none
  bool is_seam(EdgeHandle e) const { return is_seam_[index(e)] != 0; }
  bool is_on_seam(VertexHandle v) const { return count_[index(v)] > 0; }

  /// Whether the seams let the vertex where a half-edge starts merge into the one where it ends. \pre not empty()
  bool allow(const Mesh& mesh, HalfedgeHandle v0v1) const;
  /// The same for a plan, which has seen to it that no slit closes and no chart that is to stay vanishes.
  bool allow_planned(const Mesh& mesh, HalfedgeHandle v0v1) const;
  /// Whether the survivor stays where it is in such a merge. \pre not empty()
  bool hold(const Mesh& mesh, HalfedgeHandle v0v1) const;
  /// Whether one of the two faces at an edge is a chart by itself: all its edges are seams or at the boundary.
  bool is_at_last_face(const Mesh& mesh, HalfedgeHandle h) const {
    return is_chart(mesh, h) || is_chart(mesh, mesh.opposite_halfedge_handle(h));
  }

  /// Passes the seams on to the edges that are left; the mesh has yet to change. \pre not empty()
  void collapse(const Mesh& mesh, HalfedgeHandle v0v1);

  /// Calls `visit(half-edge, sector)` for each corner at `v`, by the half-edge that points to it. Corners with a
  /// seam or the boundary between them are in different sectors.
  template <typename Visit>
  void for_each_corner(const Mesh& mesh, VertexHandle v, Visit visit) const;

 private:
  template <typename Handle>
  static std::size_t index(Handle h) {
    return static_cast<std::size_t>(h.idx());
  }
  /// The half-edges from `v`, one after the other, from an open one on if there is one.
  template <typename Visit>
  static void for_each_spoke(const Mesh& mesh, VertexHandle v, Visit visit);

  bool is_seam(const Mesh& mesh, HalfedgeHandle h) const { return is_seam(mesh.edge_handle(h)); }
  static bool is_open(const Mesh& mesh, HalfedgeHandle h) {
    return mesh.is_boundary(h) || mesh.is_boundary(mesh.opposite_halfedge_handle(h));
  }
  /// Whether a vertex is the end of a slit, which stays, as a slit that becomes shorter closes.
  bool ends_slit(const Mesh& mesh, VertexHandle v) const {
    return count_[index(v)] == 1 && !mesh.is_boundary(v);
  }
  bool is_chart(const Mesh& mesh, HalfedgeHandle h) const;
  bool closes_slit(const Mesh& mesh, HalfedgeHandle v0v1) const;
  void mark_slits(const Mesh& mesh);

  std::vector<std::uint8_t> is_seam_;  // of each edge; empty if none is
  std::vector<std::uint32_t> count_;   // of each vertex: how many of its edges are seams
  std::vector<std::uint8_t> on_slit_;  // of each vertex: on a seam with one chart on both sides
};

template <typename Mesh>
template <typename Visit>
void MovingSeamsT<Mesh>::for_each_spoke(const Mesh& mesh, VertexHandle v, Visit visit) {
  const HalfedgeHandle first = mesh.halfedge_handle(v);
  HalfedgeHandle h = first;
  if (!h.is_valid()) return;
  do visit(h);
  while ((h = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h))) != first);
}

template <typename Mesh>
void MovingSeamsT<Mesh>::take_snapshot(const Mesh& mesh) {
  *this = {};
  if (!has_corner_attributes(mesh)) return;
  std::vector<std::uint8_t> is_seam(mesh.n_edges(), 0);
  bool any = false;
  for (std::size_t e = 0; e < is_seam.size(); ++e) {
    const EdgeHandle edge(static_cast<int>(e));
    if (mesh.has_edge_status() && mesh.status(edge).deleted()) continue;
    is_seam[e] = detail::is_seam(mesh, mesh.halfedge_handle(edge, 0));
    any |= is_seam[e] != 0;
  }
  if (!any) return;
  is_seam_ = std::move(is_seam);
  count_.assign(mesh.n_vertices(), 0);
  for (std::size_t e = 0; e < is_seam_.size(); ++e) {
    if (is_seam_[e] == 0) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0);
    ++count_[index(mesh.from_vertex_handle(h))];
    ++count_[index(mesh.to_vertex_handle(h))];
  }
  mark_slits(mesh);
}

template <typename Mesh>
void MovingSeamsT<Mesh>::mark_slits(const Mesh& mesh) {
  UnionFind charts(mesh.n_faces());
  const auto face = [&](HalfedgeHandle h) { return static_cast<std::uint32_t>(mesh.face_handle(h).idx()); };
  const auto for_each_inner = [&](auto visit) {
    for (std::size_t e = 0; e < is_seam_.size(); ++e) {
      const EdgeHandle edge(static_cast<int>(e));
      if (mesh.has_edge_status() && mesh.status(edge).deleted()) continue;
      const HalfedgeHandle h = mesh.halfedge_handle(edge, 0);
      if (!is_open(mesh, h)) visit(h, mesh.opposite_halfedge_handle(h));
    }
  };
  for_each_inner([&](HalfedgeHandle h, HalfedgeHandle o) {
    if (!is_seam(mesh, h)) charts.join(face(h), face(o));
  });
  on_slit_.assign(mesh.n_vertices(), 0);
  for_each_inner([&](HalfedgeHandle h, HalfedgeHandle o) {
    if (is_seam(mesh, h) && charts.root(face(h)) == charts.root(face(o)))
      on_slit_[index(mesh.to_vertex_handle(h))] = on_slit_[index(mesh.to_vertex_handle(o))] = 1;
  });
}

template <typename Mesh>
bool MovingSeamsT<Mesh>::is_chart(const Mesh& mesh, HalfedgeHandle h) const {
  if (mesh.is_boundary(h)) return false;
  const auto ends = [&](HalfedgeHandle at) { return is_open(mesh, at) || is_seam(mesh, at); };
  return ends(h) && ends(mesh.next_halfedge_handle(h)) && ends(mesh.prev_halfedge_handle(h));
}

template <typename Mesh>
bool MovingSeamsT<Mesh>::allow_planned(const Mesh& mesh, HalfedgeHandle v0v1) const {
  const VertexHandle v0 = mesh.from_vertex_handle(v0v1), v1 = mesh.to_vertex_handle(v0v1);
  if (!is_on_seam(v0)) return true;
  if (!is_on_seam(v1) || ends_slit(mesh, v0) || (mesh.is_boundary(v0) && !mesh.is_boundary(v1))) return false;
  return is_seam(mesh, v0v1) || is_open(mesh, v0v1);
}

template <typename Mesh>
bool MovingSeamsT<Mesh>::allow(const Mesh& mesh, HalfedgeHandle v0v1) const {
  if (!is_on_seam(mesh.from_vertex_handle(v0v1))) return true;
  if (!allow_planned(mesh, v0v1) || closes_slit(mesh, v0v1)) return false;
  return !is_open(mesh, v0v1) || is_at_last_face(mesh, v0v1);
}

template <typename Mesh>
bool MovingSeamsT<Mesh>::hold(const Mesh& mesh, HalfedgeHandle v0v1) const {
  const VertexHandle v0 = mesh.from_vertex_handle(v0v1), v1 = mesh.to_vertex_handle(v0v1);
  if (!is_on_seam(v1)) return false;
  return !is_on_seam(v0) || ends_slit(mesh, v1) || (mesh.is_boundary(v1) && !mesh.is_boundary(v0));
}

/// Whether a merge takes the last vertex between a slit's two ends. \pre v0 is no end
template <typename Mesh>
bool MovingSeamsT<Mesh>::closes_slit(const Mesh& mesh, HalfedgeHandle v0v1) const {
  const VertexHandle v0 = mesh.from_vertex_handle(v0v1), v1 = mesh.to_vertex_handle(v0v1);
  if (!is_seam(mesh, v0v1) || count_[index(v0)] != 2 || !ends_slit(mesh, v1)) return false;
  bool ends_other = true;
  for_each_spoke(mesh, v0, [&](HalfedgeHandle h) {
    if (h != v0v1 && is_seam(mesh, h)) ends_other = ends_slit(mesh, mesh.to_vertex_handle(h));
  });
  return ends_other;
}

/// Of each face that vanishes two edges become one: a seam if either was, unless it is at the boundary now. A chart of
/// one face is gone with it, and where one chart surrounds its tip, that is no seam any more, except on a slit; see
/// `mq::fuse_seams`.
template <typename Mesh>
void MovingSeamsT<Mesh>::collapse(const Mesh& mesh, HalfedgeHandle v0v1) {
  const VertexHandle v0 = mesh.from_vertex_handle(v0v1), v1 = mesh.to_vertex_handle(v0v1);
  const bool open = mesh.is_boundary(v0) || mesh.is_boundary(v1);
  std::uint32_t& count = count_[index(v1)];
  if (count + count_[index(v0)] == 0) return;
  count += count_[index(v0)];
  count_[index(v0)] = 0;
  if (is_seam(mesh, v0v1)) count -= 2;
  /// A face that vanishes: its edge at v1, which is left, that at v0, and its tip.
  struct Side {
    HalfedgeHandle left, gone;
    VertexHandle tip;
    bool closes = false;
  };
  const HalfedgeHandle o = mesh.opposite_halfedge_handle(v0v1);
  const HalfedgeHandle next = mesh.next_halfedge_handle(v0v1), after = mesh.next_halfedge_handle(o);
  std::array<Side, 2> sides;
  if (!mesh.is_boundary(v0v1))
    sides[0] = {next, mesh.prev_halfedge_handle(v0v1), mesh.to_vertex_handle(next)};
  if (!mesh.is_boundary(o)) sides[1] = {mesh.prev_halfedge_handle(o), after, mesh.to_vertex_handle(after)};
  std::uint32_t n_closing = 0;
  const auto clear = [&](const Side& side) {
    is_seam_[index(mesh.edge_handle(side.left))] = 0;
    --count;
    --count_[index(side.tip)];
  };
  for (Side& side : sides) {
    if (!side.left.is_valid()) continue;
    const bool at_v1 = is_seam(mesh, side.left), at_v0 = is_seam(mesh, side.gone);
    if (!at_v1 && !at_v0) continue;
    if (is_open(mesh, side.left) || is_open(mesh, side.gone)) {
      clear(side);
      continue;
    }
    is_seam_[index(mesh.edge_handle(side.left))] = 1;
    if (!at_v1 || !at_v0) continue;
    --count;
    --count_[index(side.tip)];
    side.closes = count_[index(side.tip)] == 1 && !mesh.is_boundary(side.tip);
    n_closing += side.closes;
  }
  const bool on_slit = on_slit_[index(v0)] != 0 || on_slit_[index(v1)] != 0;
  const bool leaves_slit = on_slit || (!open && count == n_closing + 1);
  for (const Side& side : sides)
    if (side.closes && !leaves_slit) clear(side);
  on_slit_[index(v1)] = on_slit;
}

template <typename Mesh>
template <typename Visit>
void MovingSeamsT<Mesh>::for_each_corner(const Mesh& mesh, VertexHandle v, Visit visit) const {
  const auto parts = [&](HalfedgeHandle spoke) { return is_open(mesh, spoke) || is_seam(mesh, spoke); };
  // Sectors are counted from a spoke that parts two, if there is one.
  HalfedgeHandle first = mesh.halfedge_handle(v);
  for_each_spoke(mesh, v, [&](HalfedgeHandle spoke) {
    if (!parts(first) && parts(spoke)) first = spoke;
  });
  std::uint32_t sector = 0;
  HalfedgeHandle spoke = first;
  if (!spoke.is_valid()) return;
  do {
    if (spoke != first && parts(spoke)) ++sector;
    if (!mesh.is_boundary(spoke)) visit(mesh.prev_halfedge_handle(spoke), sector);
    spoke = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(spoke));
  } while (spoke != first);
}

}  // namespace whittle::detail
