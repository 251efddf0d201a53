/// \file
/// The seams of half-edge texture coordinates while vertices merge along them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/openmesh/InputFaces.hh"
#include "whittle/surface/charts.hh"

namespace whittle::detail {

/// Which edges of an OpenMesh mesh are seams, and what collapses make of them. The rules are those of mq
/// (`mq/seams.hh`): two vertices on seams merge along a seam edge only, or along the boundary where the chart between
/// them is a single face, and one inside a chart may merge into one on a seam. The outer ends of two spokes around a hub
/// merge, too, as `mq::Mesh::joins_spokes` says.
template <typename Mesh>
class MovingSeamsT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  using EdgeHandle = typename Mesh::EdgeHandle;

  MovingSeamsT() = default;  ///< none
  /// The seams of a mesh as it is.
  /// \param input  the same mesh, with wedges
  MovingSeamsT(const Mesh& mesh, const InputFaces& input, const EdgeChains& chains, const Charts& charts);

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

  /// Calls `visit(half-edge)` for those that start at `v`, in the same order; from an open one on if there is one.
  template <typename Visit>
  static void for_each_spoke(const Mesh& mesh, VertexHandle v, Visit visit);

 private:
  template <typename Handle>
  static std::size_t index(Handle h) {
    return static_cast<std::size_t>(h.idx());
  }
  bool is_seam(const Mesh& mesh, HalfedgeHandle h) const { return is_seam(mesh.edge_handle(h)); }
  static bool is_open(const Mesh& mesh, HalfedgeHandle h) {
    return mesh.is_boundary(h) || mesh.is_boundary(mesh.opposite_halfedge_handle(h));
  }
  /// Whether a vertex is the end of a slit, which stays, as a slit that becomes shorter closes.
  bool ends_slit(const Mesh& mesh, VertexHandle v) const {
    return count_[index(v)] == 1 && !mesh.is_boundary(v);
  }
  bool is_chart(const Mesh& mesh, HalfedgeHandle h) const;
  bool joins_spokes(const Mesh& mesh, HalfedgeHandle v0v1) const;
  bool closes_slit(const Mesh& mesh, HalfedgeHandle v0v1) const;

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
MovingSeamsT<Mesh>::MovingSeamsT(const Mesh& mesh, const InputFaces& input, const EdgeChains& chains,
                                 const Charts& charts)
    : is_seam_(mesh.n_edges(), 0), count_(mesh.n_vertices(), 0), on_slit_(mesh.n_vertices(), 0) {
  const auto is_apart = [&](std::uint32_t s, std::uint32_t t) {
    return chains.next(s) == t && !chains.agrees(s);
  };
  for (std::size_t e = 0; e < is_seam_.size(); ++e) {
    const std::uint32_t s = input.side[2 * e], t = input.side[2 * e + 1];
    if (s == InputFaces::kNone || t == InputFaces::kNone || !(is_apart(s, t) || is_apart(t, s))) continue;
    is_seam_[e] = 1;
    const HalfedgeHandle h = mesh.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0);
    for (const VertexHandle v : {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)}) {
      ++count_[index(v)];
      if (charts.of_face[s / 3] == charts.of_face[t / 3]) on_slit_[index(v)] = 1;
    }
  }
}

template <typename Mesh>
bool MovingSeamsT<Mesh>::is_chart(const Mesh& mesh, HalfedgeHandle h) const {
  if (mesh.is_boundary(h)) return false;
  const auto ends = [&](HalfedgeHandle at) { return is_open(mesh, at) || is_seam(mesh, at); };
  return ends(h) && ends(mesh.next_halfedge_handle(h)) && ends(mesh.prev_halfedge_handle(h));
}

/// Whether both ends are those of slits of one edge that meet at a hub, and the face between them closes.
template <typename Mesh>
bool MovingSeamsT<Mesh>::joins_spokes(const Mesh& mesh, HalfedgeHandle v0v1) const {
  if (!ends_slit(mesh, mesh.from_vertex_handle(v0v1)) || !ends_slit(mesh, mesh.to_vertex_handle(v0v1)) ||
      is_seam(mesh, v0v1))
    return false;
  for (const HalfedgeHandle h : {v0v1, mesh.opposite_halfedge_handle(v0v1)}) {
    if (mesh.is_boundary(h)) continue;
    const HalfedgeHandle next = mesh.next_halfedge_handle(h);
    if (is_seam(mesh, next) && is_seam(mesh, mesh.prev_halfedge_handle(h)) &&
        count_[index(mesh.to_vertex_handle(next))] > 3)
      return true;
  }
  return false;
}

template <typename Mesh>
bool MovingSeamsT<Mesh>::allow_planned(const Mesh& mesh, HalfedgeHandle v0v1) const {
  const VertexHandle v0 = mesh.from_vertex_handle(v0v1), v1 = mesh.to_vertex_handle(v0v1);
  if (!is_on_seam(v0) || joins_spokes(mesh, v0v1)) return true;
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
  if (!is_on_seam(v1) || joins_spokes(mesh, v0v1)) return false;
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
  const HalfedgeHandle any = mesh.halfedge_handle(v);
  if (!any.is_valid()) return;
  const auto after = [&](HalfedgeHandle spoke) {
    return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(spoke));
  };
  HalfedgeHandle first = any;
  while (!parts(first) && (first = after(first)) != any) continue;
  std::uint32_t sector = 0;
  HalfedgeHandle spoke = first;
  do {
    if (spoke != first && parts(spoke)) ++sector;
    if (!mesh.is_boundary(spoke)) visit(mesh.prev_halfedge_handle(spoke), sector);
    spoke = after(spoke);
  } while (spoke != first);
}

}  // namespace whittle::detail
