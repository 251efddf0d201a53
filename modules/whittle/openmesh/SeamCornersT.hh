/// \file
/// From where in the input the corners at a vertex on seams take their values.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/openmesh/MovingSeamsT.hh"
#include "whittle/openmesh/describe.hh"
#include "whittle/plan/SeamPlaces.hh"
#include "whittle/surface/seams.hh"

namespace whittle::detail {

/// The seams of a mesh while its vertices merge, and the mesh as it was at `take_snapshot()`, of which each survivor
/// knows the vertices that became it. Without seams it holds nothing.
template <typename Mesh>
class SeamCornersT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  /// From now on, the mesh as it is is the input.
  void take_snapshot(const Mesh& mesh);

  bool empty() const { return !input_; }  ///< whether there are no seams
  const MovingSeamsT<Mesh>& seams() const { return seams_; }

  /// Before the collapse of a half-edge.
  void before(const Mesh& mesh, HalfedgeHandle v0v1) { seams_.collapse(mesh, v0v1); }
  /// After it.
  /// \return whether one of the vertices that have become `v1` was on a seam, so that its corners may differ.
  bool merge(VertexHandle v0, VertexHandle v1) {
    std::swap(next_[index(v0)], next_[index(v1)]);
    return was_on_seam_[index(v1)] = was_on_seam_[index(v1)] || was_on_seam_[index(v0)];
  }

  /// Calls `visit(half-edge, place)` for each corner at `v`, by the half-edge that points to it. A place's face is that
  /// of the mesh, and the half-edge of the face that OpenMesh names points to the second of its corners.
  template <typename Visit>
  void for_each_place(const Mesh& mesh, VertexHandle v, Visit visit);

 private:
  using Triangles = SeamPlaces::Triangles;

  /// What does not move with this.
  struct Input {
    std::vector<Eigen::Vector3d> points;  // and one more, for faces that were deleted already
    Triangles triangles, wedges;
    SeamPlaces places = {points, triangles, wedges};
  };
  static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

  MovingSeamsT<Mesh> seams_;
  std::unique_ptr<Input> input_;
  std::vector<std::uint32_t> next_;  // of each vertex: the next of those that became one with it
  std::vector<bool> was_on_seam_;    // of each vertex: it, or one that has become it
  // At the current vertex:
  std::vector<std::uint32_t> members_;
  std::vector<SeamPlaces::Corner> corners_;
  std::vector<HalfedgeHandle> halfedges_;
};

template <typename Mesh>
void SeamCornersT<Mesh>::take_snapshot(const Mesh& mesh) {
  *this = SeamCornersT();
  seams_.take_snapshot(mesh);
  if (seams_.empty()) return;
  const auto n = static_cast<std::uint32_t>(mesh.n_vertices());
  std::vector<Eigen::Vector3d> points;
  points.reserve(n + std::size_t{1});
  was_on_seam_.resize(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    const VertexHandle vertex(static_cast<int>(v));
    const auto& p = mesh.point(vertex);
    points.emplace_back(double(p[0]), double(p[1]), double(p[2]));
    was_on_seam_[v] = seams_.is_on_seam(vertex);
  }
  points.emplace_back(Eigen::Vector3d::Zero());
  Triangles triangles(mesh.n_faces(), {n, n, n}), wedges(mesh.n_faces(), {0, 0, 0});
  const Triangles living = corner_wedges(mesh);
  auto wedge = living.begin();
  for_each_triangle(mesh, [&](std::size_t f, const auto& t) {
    triangles[f] = {t[2], t[0], t[1]};  // from where OpenMesh's half-edge begins
    wedges[f] = {(*wedge)[2], (*wedge)[0], (*wedge)[1]};
    ++wedge;
    return true;
  });
  input_.reset(new Input{std::move(points), std::move(triangles), std::move(wedges)});
  next_.resize(n);
  std::iota(next_.begin(), next_.end(), 0u);
}

template <typename Mesh>
template <typename Visit>
void SeamCornersT<Mesh>::for_each_place(const Mesh& mesh, VertexHandle v, Visit visit) {
  members_.clear();
  auto member = static_cast<std::uint32_t>(v.idx());
  do members_.push_back(member);
  while ((member = next_[member]) != static_cast<std::uint32_t>(v.idx()));
  std::sort(members_.begin(), members_.end());
  corners_.clear();
  halfedges_.clear();
  seams_.for_each_corner(mesh, v, [&](HalfedgeHandle h, std::uint32_t sector) {
    corners_.push_back({static_cast<std::uint32_t>(mesh.face_handle(h).idx()), sector});
    halfedges_.push_back(h);
  });
  if (corners_.empty()) return;
  const auto& p = mesh.point(v);
  input_->places.find({double(p[0]), double(p[1]), double(p[2])},
                      {members_.data(), members_.data() + members_.size()}, corners_);
  for (std::size_t i = 0; i < halfedges_.size(); ++i)
    visit(halfedges_[i], input_->places.place(input_->places.group(i)));
}

}  // namespace whittle::detail
