/// \file
/// What becomes of normals, colours and texture coordinates when vertices merge.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/openmesh/FaceWalkT.hh"
#include "whittle/openmesh/SeamCornersT.hh"
#include "whittle/openmesh/components.hh"
#include "whittle/openmesh/describe.hh"

namespace whittle::detail {

/// What becomes of the place of a vertex that others merge into.
enum class Survivors { move, stay };

/// The attributes of a mesh while its vertices merge: a survivor that moves takes the values at the nearest
/// point of the mesh as it was at `take_snapshot()`, one that stays keeps its own. The texture coordinates of
/// half-edges are those of the corner's own side of a seam, at the same place of the seam on both sides. Only
/// attributes that the mesh has; without any, nothing is stored and nothing is done.
template <typename Mesh>
class SurvivorAttributesT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  /// From now on, the mesh as it is is the input.
  /// \param mesh       of triangles
  /// \param survivors  `stay`: none is ever said to have moved
  void take_snapshot(const Mesh& mesh, Survivors survivors = Survivors::move);

  /// The seams as collapses leave them.
  const MovingSeamsT<Mesh>& seams() const { return seam_corners_.seams(); }

  bool empty() const { return !has_vertices_ && !has_corners_; }

  /// Before the collapse of a half-edge.
  void before(Mesh& mesh, HalfedgeHandle v0v1);

  /// After it, and after `v1` has been moved if it is to be.
  void after(Mesh& mesh, VertexHandle v0, VertexHandle v1, bool moved);

 private:
  using FaceWalk = FaceWalkT<Mesh>;

  /// Calls `visit(values, get, set)` for each attribute that the mesh has, with the values of the input.
  template <typename Self, typename AnyMesh, typename Visit>
  static void for_each_of_vertices(Self& self, AnyMesh& mesh, Visit visit);
  template <typename Self, typename AnyMesh, typename Visit>
  static void for_each_of_corners(Self& self, AnyMesh& mesh, Visit visit);

  template <typename Normal>
  static Normal unit(Normal n);

  void sample_vertex(Mesh& mesh, VertexHandle v, const typename FaceWalk::Spot& spot) const;
  void sample_corners(Mesh& mesh, VertexHandle v, const typename FaceWalk::Spot& spot) const;
  void sample_seams(Mesh& mesh, VertexHandle v);

  FaceWalk walk_;
  std::vector<std::uint32_t> face_;       // of the input, nearest to each vertex
  std::vector<HalfedgeHandle> arriving_;  // pointed to v0 before the collapse
  HalfedgeHandle at_v1_;                  // has the coordinates that they take if v1 stays and is on no seam
  SeamCornersT<Mesh> seam_corners_;
  bool has_vertices_ = false, has_corners_ = false;
  // Of each vertex of the input, or of each corner of the walk; empty: the mesh had none.
  std::vector<typename Mesh::Normal> normals_;
  std::vector<typename Mesh::Color> colours_;
  std::vector<typename Mesh::TexCoord1D> texture1_, corners1_;
  std::vector<typename Mesh::TexCoord2D> texture2_, corners2_;
  std::vector<typename Mesh::TexCoord3D> texture3_, corners3_;
};

template <typename Mesh>
template <typename Self, typename AnyMesh, typename Visit>
void SurvivorAttributesT<Mesh>::for_each_of_vertices(Self& self, AnyMesh& mesh, Visit visit) {
  if (mesh.has_vertex_normals())
    visit(
        self.normals_, [&](auto v) { return mesh.normal(v); },
        [&](auto v, const auto& x) { mesh.set_normal(v, unit(x)); });
  if (mesh.has_vertex_colors())
    visit(
        self.colours_, [&](auto v) { return mesh.color(v); },
        [&](auto v, const auto& x) { mesh.set_color(v, x); });
  if (mesh.has_vertex_texcoords1D())
    visit(
        self.texture1_, [&](auto v) { return mesh.texcoord1D(v); },
        [&](auto v, const auto& x) { mesh.set_texcoord1D(v, x); });
  if (mesh.has_vertex_texcoords2D())
    visit(
        self.texture2_, [&](auto v) { return mesh.texcoord2D(v); },
        [&](auto v, const auto& x) { mesh.set_texcoord2D(v, x); });
  if (mesh.has_vertex_texcoords3D())
    visit(
        self.texture3_, [&](auto v) { return mesh.texcoord3D(v); },
        [&](auto v, const auto& x) { mesh.set_texcoord3D(v, x); });
}

template <typename Mesh>
template <typename Self, typename AnyMesh, typename Visit>
void SurvivorAttributesT<Mesh>::for_each_of_corners(Self& self, AnyMesh& mesh, Visit visit) {
  if (mesh.has_halfedge_texcoords1D())
    visit(
        self.corners1_, [&](auto h) { return mesh.texcoord1D(h); },
        [&](auto h, const auto& x) { mesh.set_texcoord1D(h, x); });
  if (mesh.has_halfedge_texcoords2D())
    visit(
        self.corners2_, [&](auto h) { return mesh.texcoord2D(h); },
        [&](auto h, const auto& x) { mesh.set_texcoord2D(h, x); });
  if (mesh.has_halfedge_texcoords3D())
    visit(
        self.corners3_, [&](auto h) { return mesh.texcoord3D(h); },
        [&](auto h, const auto& x) { mesh.set_texcoord3D(h, x); });
}

template <typename Mesh>
template <typename Normal>
Normal SurvivorAttributesT<Mesh>::unit(Normal n) {
  double squares = 0;
  for (std::uint32_t i = 0; i < 3; ++i) squares += double(component(n, i)) * double(component(n, i));
  if (!(squares > 0)) return n;
  using Scalar = typename ComponentsT<Normal>::Scalar;
  for (std::uint32_t i = 0; i < 3; ++i)
    component(n, i) = static_cast<Scalar>(double(component(n, i)) / std::sqrt(squares));
  return n;
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::take_snapshot(const Mesh& mesh, Survivors survivors) {
  *this = SurvivorAttributesT();
  if (survivors == Survivors::move)
    for_each_of_vertices(*this, mesh, [&](auto& values, auto get, auto /*set*/) {
      has_vertices_ = true;
      for (std::size_t v = 0; v < mesh.n_vertices(); ++v)
        values.push_back(get(VertexHandle(static_cast<int>(v))));
    });
  seam_corners_.take_snapshot(mesh);
  for_each_of_corners(*this, mesh, [&](auto& values, auto get, auto /*set*/) {
    has_corners_ = true;
    if (survivors == Survivors::stay && seam_corners_.empty()) return;
    values.resize(3 * mesh.n_faces());
    for (std::size_t f = 0; f < mesh.n_faces(); ++f) {
      const typename Mesh::FaceHandle face(static_cast<int>(f));
      if (mesh.has_face_status() && mesh.status(face).deleted()) continue;
      auto h = mesh.prev_halfedge_handle(mesh.halfedge_handle(face));  // it points to the first corner
      for (std::size_t i = 0; i < 3; ++i, h = mesh.next_halfedge_handle(h)) values[3 * f + i] = get(h);
    }
  });
  if (survivors == Survivors::stay || (!has_vertices_ && !has_corners_)) return;
  walk_ = FaceWalk(mesh);
  for (std::uint32_t v = 0; v < mesh.n_vertices(); ++v) face_.push_back(walk_.a_face(v));
}

/// Off the seams one value holds all around `v0`, and the corners that come to `v1` take the value in the faces at the
/// edge. Where the edge from `v0` to the tip on the left is a seam, the half-edge that takes its place is of the other
/// side.
template <typename Mesh>
void SurvivorAttributesT<Mesh>::before(Mesh& mesh, HalfedgeHandle v0v1) {
  if (!has_corners_) return;
  if (!seam_corners_.empty()) {
    if (!mesh.is_boundary(v0v1)) {
      const auto beyond = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(v0v1));
      const auto instead = mesh.next_halfedge_handle(v0v1);
      for_each_of_corners(*this, mesh, [&](const auto&, auto get, auto set) { set(instead, get(beyond)); });
    }
    seam_corners_.before(mesh, v0v1);
  }
  arriving_.clear();
  for (auto h = mesh.cvih_iter(mesh.from_vertex_handle(v0v1)); h.is_valid(); ++h) arriving_.push_back(*h);
  at_v1_ = mesh.is_boundary(v0v1) ? mesh.prev_halfedge_handle(mesh.opposite_halfedge_handle(v0v1)) : v0v1;
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::after(Mesh& mesh, VertexHandle v0, VertexHandle v1, bool moved) {
  if (!has_vertices_ && !has_corners_) return;
  const bool on_seam = !seam_corners_.empty() && seam_corners_.merge(v0, v1);
  if (on_seam) sample_seams(mesh, v1);
  if (!moved) {
    if (on_seam) return;
    for_each_of_corners(*this, mesh, [&](const auto& /*values*/, auto get, auto set) {
      for (const HalfedgeHandle h : arriving_)
        if (mesh.to_vertex_handle(h) == v1) set(h, get(at_v1_));
    });
    return;
  }
  std::uint32_t& face = face_[static_cast<std::size_t>(v1.idx())];
  const auto& p = mesh.point(v1);
  const auto spot = walk_.nearest({double(p[0]), double(p[1]), double(p[2])},
                                  {face, face_[static_cast<std::size_t>(v0.idx())]});
  face = spot.face;
  sample_vertex(mesh, v1, spot);
  if (!on_seam) sample_corners(mesh, v1, spot);
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample_vertex(Mesh& mesh, VertexHandle v,
                                              const typename FaceWalk::Spot& spot) const {
  for_each_of_vertices(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
    if (values.empty()) return;  // requested since the snapshot
    const auto at = [&](std::uint32_t i) { return &values[walk_.vertex(3 * spot.face + i)]; };
    set(v, interpolated(std::array{at(0), at(1), at(2)}, spot.shares));
  });
}

/// Where nothing that became the vertex was on a seam, all its corners take the same value.
template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample_corners(Mesh& mesh, VertexHandle v,
                                               const typename FaceWalk::Spot& spot) const {
  for_each_of_corners(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
    if (values.empty()) return;
    const auto at = [&](std::size_t i) { return &values[std::size_t{3} * spot.face + i]; };
    const auto value = interpolated(std::array{at(0), at(1), at(2)}, spot.shares);
    for (auto h = mesh.vih_iter(v); h.is_valid(); ++h) set(*h, value);
  });
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample_seams(Mesh& mesh, VertexHandle v) {
  seam_corners_.for_each_place(mesh, v, [&](HalfedgeHandle h, const SeamPlaces::Place& place) {
    for_each_of_corners(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
      if (values.empty()) return;
      const auto at = [&](std::size_t i) { return &values[std::size_t{3} * place.face + i]; };
      set(h, interpolated(std::array{at(0), at(1), at(2)}, place.shares));
    });
  });
}

}  // namespace whittle::detail
