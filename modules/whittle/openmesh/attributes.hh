/// \file
/// What becomes of normals, colours and texture coordinates when vertices merge.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/openmesh/FaceWalk.hh"
#include "whittle/openmesh/InputFaces.hh"
#include "whittle/openmesh/MovingSeamsT.hh"
#include "whittle/openmesh/SeamCornersT.hh"
#include "whittle/openmesh/components.hh"
#include "whittle/openmesh/describe.hh"
#include "whittle/surface/Lists.hh"
#include "whittle/surface/charts.hh"

namespace whittle::detail {

/// What becomes of the place of a vertex that others merge into.
enum class Survivors { move, stay };

/// The attributes of a mesh while its vertices merge: a survivor that moves takes the values at the nearest
/// point of the mesh as it was at `take_snapshot()`, one that stays keeps its own. The texture coordinates of
/// half-edges are those of the corner's own side of a seam, at the same place of the seam on both sides. Only
/// attributes that the mesh has; without any, nothing is stored and nothing is done.
///
/// Values depend on where a vertex is and on what has merged into it, not on when they are looked up: after each collapse
/// or once at the end.
template <typename Mesh>
class SurvivorAttributesT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  /// From now on, the mesh as it is is the input.
  /// \param mesh       of triangles
  /// \param numbers    as `corner_numbers` makes them
  /// \param survivors  `stay`: none is ever said to have moved
  void take_snapshot(const Mesh& mesh, const std::vector<std::uint32_t>& numbers,
                     Survivors survivors = Survivors::move);

  /// The seams as collapses leave them, and what they enclosed in the input.
  const MovingSeamsT<Mesh>& seams() const { return seams_; }
  const Charts& charts() const { return charts_; }
  /// \pre not empty()
  const InputFaces& input() const { return *input_; }

  bool empty() const { return !has_vertices_ && !has_corners_; }

  /// Before the collapse of a half-edge.
  void before(Mesh& mesh, HalfedgeHandle v0v1);
  /// After it, and after `v1` has been moved if it is to be.
  void merge(const Mesh& mesh, VertexHandle v0, VertexHandle v1, bool moved);
  /// After a vertex has been moved otherwise.
  void move(VertexHandle v) {
    if (!empty()) has_moved_[index(v)] = 1;
  }
  /// A vertex that has moved or that another has merged into takes its values.
  void sample(Mesh& mesh, VertexHandle v);

 private:
  static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

  /// Calls `visit(values, get, set)` for each attribute that the mesh has, with the values of the input.
  template <typename Self, typename AnyMesh, typename Visit>
  static void for_each_of_vertices(Self& self, AnyMesh& mesh, Visit visit);
  template <typename Self, typename AnyMesh, typename Visit>
  static void for_each_of_corners(Self& self, AnyMesh& mesh, Visit visit);

  template <typename Normal>
  static Normal unit(Normal n);

  FaceWalk::Spot nearest(const Mesh& mesh, VertexHandle v) const;
  void sample_vertex(Mesh& mesh, VertexHandle v, const FaceWalk::Spot& spot) const;
  void sample_corners(Mesh& mesh, VertexHandle v, const FaceWalk::Spot& spot) const;
  void keep_corners(Mesh& mesh, VertexHandle v) const;
  void sample_seams(Mesh& mesh, VertexHandle v);

  bool has_vertices_ = false, has_corners_ = false;
  std::unique_ptr<const InputFaces> input_;
  FaceWalk walk_;
  Charts charts_;
  MovingSeamsT<Mesh> seams_;
  std::unique_ptr<SeamCornersT<Mesh>> seam_corners_;  // if there are seams
  // Of each vertex:
  std::vector<std::uint32_t> next_;      // the next of those that became one with it
  std::vector<std::uint8_t> has_moved_;  // since the snapshot
  std::vector<std::uint8_t> on_seam_;    // it, or one that has become it, was; empty without seams
  std::vector<std::uint32_t> members_;   // those that became one, of the vertex that is looked at
  // Of each vertex of the input, or of each corner; empty: the mesh had none.
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
void SurvivorAttributesT<Mesh>::take_snapshot(const Mesh& mesh, const std::vector<std::uint32_t>& numbers,
                                              Survivors survivors) {
  *this = SurvivorAttributesT();
  if (survivors == Survivors::move)
    for_each_of_vertices(*this, mesh, [&](auto& values, auto get, auto /*set*/) {
      has_vertices_ = true;
      values.reserve(mesh.n_vertices());
      for (std::size_t v = 0; v < mesh.n_vertices(); ++v)
        values.push_back(get(VertexHandle(static_cast<int>(v))));
    });
  has_corners_ = has_corner_attributes(mesh);
  if (empty()) return;
  auto input = std::make_unique<InputFaces>(mesh, numbers);
  EdgeChains chains = std::move(input->chains);
  input_ = std::move(input);
  walk_ = FaceWalk(*input_);
  next_.resize(mesh.n_vertices());
  std::iota(next_.begin(), next_.end(), 0u);
  has_moved_.assign(mesh.n_vertices(), 0);
  for_each_of_corners(*this, mesh, [&](auto& values, auto get, auto /*set*/) {
    values.resize(3 * mesh.n_faces());
    for (std::size_t i = 0; i < input_->side.size(); ++i) {
      const std::uint32_t side = input_->side[i];  // its half-edge points to the next corner
      if (side == InputFaces::kNone) continue;
      values[side % 3 == 2 ? side - 2 : side + 1] = get(HalfedgeHandle(static_cast<int>(i)));
    }
  });
  if (numbers.empty()) return;
  const std::uint32_t nowhere = static_cast<std::uint32_t>(mesh.n_vertices());
  charts_ = detail::charts(chains, [&](std::uint32_t f) { return input_->triangles[f][0] != nowhere; });
  seams_ = MovingSeamsT<Mesh>(mesh, *input_, chains, charts_);
  seam_corners_ = std::make_unique<SeamCornersT<Mesh>>(*input_, std::move(chains));
  on_seam_.resize(mesh.n_vertices());
  for (std::size_t v = 0; v < on_seam_.size(); ++v)
    on_seam_[v] = seams_.is_on_seam(VertexHandle(static_cast<int>(v)));
}

/// Where the edge from `v0` to the tip on the left is a seam, the half-edge that takes its place is of the other side.
template <typename Mesh>
void SurvivorAttributesT<Mesh>::before(Mesh& mesh, HalfedgeHandle v0v1) {
  if (seams_.empty() ||
      (!seams_.is_on_seam(mesh.from_vertex_handle(v0v1)) && !seams_.is_on_seam(mesh.to_vertex_handle(v0v1))))
    return;
  const auto left = mesh.prev_halfedge_handle(v0v1);
  if (!mesh.is_boundary(v0v1) && seams_.is_seam(mesh.edge_handle(left))) {
    const auto beyond = mesh.opposite_halfedge_handle(left), instead = mesh.next_halfedge_handle(v0v1);
    for_each_of_corners(*this, mesh, [&](const auto&, auto get, auto set) { set(instead, get(beyond)); });
  }
  seams_.collapse(mesh, v0v1);
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::merge(const Mesh& mesh, VertexHandle v0, VertexHandle v1, bool moved) {
  if (empty()) return;
  std::swap(next_[index(v0)], next_[index(v1)]);
  if (moved) has_moved_[index(v1)] = 1;
  if (seams_.empty()) return;
  on_seam_[index(v1)] |= on_seam_[index(v0)];
  if (on_seam_[index(v1)] != 0) seam_corners_->note(mesh, seams_, v1);
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample(Mesh& mesh, VertexHandle v) {
  if (empty()) return;
  const bool on_seam = !on_seam_.empty() && on_seam_[index(v)] != 0;
  if (on_seam) sample_seams(mesh, v);
  if (has_moved_[index(v)] != 0 && (has_vertices_ || !on_seam)) {
    const FaceWalk::Spot spot = nearest(mesh, v);
    sample_vertex(mesh, v, spot);
    if (!on_seam) sample_corners(mesh, v, spot);
  } else if (has_corners_ && !on_seam) {
    keep_corners(mesh, v);
  }
}

/// From the nearest of the vertices that became it. Of very many only some are asked: the walk goes the rest of the way.
template <typename Mesh>
FaceWalk::Spot SurvivorAttributesT<Mesh>::nearest(const Mesh& mesh, VertexHandle v) const {
  constexpr std::size_t kMost = 64;
  const auto& at = mesh.point(v);
  const Eigen::Vector3d p{double(at[0]), double(at[1]), double(at[2])};
  const auto self = static_cast<std::uint32_t>(v.idx());
  std::uint32_t start = input_->face[self], member = self;
  double least = HUGE_VAL;
  std::size_t n = 0;
  do {
    const double square = (input_->points[member] - p).squaredNorm();
    if (square < least && input_->face[member] != InputFaces::kNone) {
      least = square;
      start = input_->face[member];
    }
    member = next_[member];
  } while (member != self && ++n < kMost);
  return walk_.nearest(p, start);
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample_vertex(Mesh& mesh, VertexHandle v, const FaceWalk::Spot& spot) const {
  for_each_of_vertices(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
    if (values.empty()) return;  // requested since the snapshot
    const auto at = [&](std::size_t k) { return &values[input_->triangles[spot.face][k]]; };
    set(v, interpolated(std::array{at(0), at(1), at(2)}, spot.shares));
  });
}

/// Where nothing that became the vertex was on a seam, all its corners take the same value.
template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample_corners(Mesh& mesh, VertexHandle v, const FaceWalk::Spot& spot) const {
  for_each_of_corners(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
    if (values.empty()) return;
    const auto at = [&](std::size_t k) { return &values[std::size_t{3} * spot.face + k]; };
    const auto value = interpolated(std::array{at(0), at(1), at(2)}, spot.shares);
    for (auto h = mesh.vih_iter(v); h.is_valid(); ++h) set(*h, value);
  });
}

/// The same, and it is where it was.
template <typename Mesh>
void SurvivorAttributesT<Mesh>::keep_corners(Mesh& mesh, VertexHandle v) const {
  const std::uint32_t face = input_->face[index(v)];
  const auto& t = input_->triangles[face];
  const auto corner = static_cast<std::size_t>(std::find(t.begin(), t.end(), index(v)) - t.begin());
  for_each_of_corners(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
    if (values.empty()) return;
    for (auto h = mesh.vih_iter(v); h.is_valid(); ++h) set(*h, values[std::size_t{3} * face + corner]);
  });
}

template <typename Mesh>
void SurvivorAttributesT<Mesh>::sample_seams(Mesh& mesh, VertexHandle v) {
  members_.clear();
  auto member = static_cast<std::uint32_t>(v.idx());
  do members_.push_back(member);
  while ((member = next_[member]) != static_cast<std::uint32_t>(v.idx()));
  std::sort(members_.begin(), members_.end());
  const Lists::Range members{members_.data(), members_.data() + members_.size()};
  seam_corners_->for_each_place(mesh, v, members, [&](HalfedgeHandle h, const SeamPlaces::Place& place) {
    for_each_of_corners(*this, mesh, [&](const auto& values, auto /*get*/, auto set) {
      if (values.empty()) return;
      const auto at = [&](std::size_t k) { return &values[std::size_t{3} * place.face + k]; };
      set(h, interpolated(std::array{at(0), at(1), at(2)}, place.shares));
    });
  });
}

}  // namespace whittle::detail
