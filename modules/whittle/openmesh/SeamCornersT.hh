/// \file
/// From where in the input the corners at a vertex on seams take their values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/openmesh/InputFaces.hh"
#include "whittle/openmesh/MovingSeamsT.hh"
#include "whittle/plan/Patches.hh"
#include "whittle/plan/SeamPlaces.hh"
#include "whittle/surface/Lists.hh"

namespace whittle::detail {

/// The corners at vertices on seams as they were when others merged into them last. What vanishes next to such a vertex
/// later changes none of its values, whenever they are looked up.
template <typename Mesh>
class SeamCornersT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  /// The input, with wedges, must outlive this. \param chains  its own
  SeamCornersT(const InputFaces& input, EdgeChains chains)
      : faces_(input.triangles, input.wedges, std::move(chains), input.points.size()),
        places_(input.points, faces_),
        noted_(input.face.size()) {}
  SeamCornersT(const SeamCornersT&) = delete;
  SeamCornersT& operator=(const SeamCornersT&) = delete;

  /// Notes the corners at a vertex.
  void note(const Mesh& mesh, const MovingSeamsT<Mesh>& seams, VertexHandle v);

  /// Calls `visit(half-edge, place)` for each corner that is left at a vertex, by the half-edge that points to it. A
  /// place's corners are those of the input's face. \pre `v` has been noted, and has not moved since
  /// \param members  the vertices that have become `v`, ascending
  template <typename Visit>
  void for_each_place(const Mesh& mesh, VertexHandle v, Lists::Range members, Visit visit);

 private:
  struct Noted {
    std::size_t first = 0;
    std::uint32_t count = 0, room = 0;
  };

  WedgedFaces faces_;
  SeamPlaces places_;
  std::vector<Noted> noted_;                 // of each vertex
  std::vector<SeamPlaces::Corner> corners_;  // of all of them
  std::vector<SeamPlaces::Corner> current_;  // of one
};

template <typename Mesh>
void SeamCornersT<Mesh>::note(const Mesh& mesh, const MovingSeamsT<Mesh>& seams, VertexHandle v) {
  current_.clear();
  seams.for_each_corner(mesh, v, [&](HalfedgeHandle h, std::uint32_t sector) {
    current_.push_back({static_cast<std::uint32_t>(mesh.face_handle(h).idx()), sector});
  });
  Noted& noted = noted_[static_cast<std::size_t>(v.idx())];
  noted.count = static_cast<std::uint32_t>(current_.size());
  if (noted.count > noted.room) {
    noted.first = corners_.size();
    noted.room = noted.count;
    corners_.resize(corners_.size() + noted.room);
  }
  std::copy(current_.begin(), current_.end(), corners_.begin() + static_cast<std::ptrdiff_t>(noted.first));
}

template <typename Mesh>
template <typename Visit>
void SeamCornersT<Mesh>::for_each_place(const Mesh& mesh, VertexHandle v, Lists::Range members, Visit visit) {
  const Noted& noted = noted_[static_cast<std::size_t>(v.idx())];
  if (noted.count == 0) return;
  const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(noted.first);
  current_.assign(first, first + noted.count);
  const auto& p = mesh.point(v);
  places_.find({double(p[0]), double(p[1]), double(p[2])}, members, current_);
  // The corners that are left are in the same order around the vertex.
  std::size_t i = 0;
  MovingSeamsT<Mesh>::for_each_spoke(mesh, v, [&](HalfedgeHandle spoke) {
    if (mesh.is_boundary(spoke)) return;
    const auto face = static_cast<std::uint32_t>(mesh.face_handle(spoke).idx());
    while (current_[i].face != face) i = i + 1 < current_.size() ? i + 1 : 0;
    visit(mesh.prev_halfedge_handle(spoke), places_.place(places_.group(i)));
  });
}

}  // namespace whittle::detail
