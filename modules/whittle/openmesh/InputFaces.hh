/// \file
/// The triangles of an OpenMesh mesh as they were, for values that are looked up there.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "whittle/surface/EdgeChains.hh"

namespace whittle::detail {

/// A copy of a mesh in flat arrays whose vertices and faces keep their indices. Corner k of face f is number 3 f + k, and
/// so is the side from it to the next corner; the first side is the half-edge that OpenMesh names for the face. Without
/// seams 36 bytes a face and 28 a vertex, with them 27 more a face.
struct InputFaces {
  using Triangles = EdgeChains::Triangles;
  static constexpr std::uint32_t kNone = EdgeChains::kNone;

  std::vector<Eigen::Vector3d> points;  ///< of each vertex, and one more for the corners of deleted faces
  Triangles triangles;
  Triangles wedges;                 ///< numbers of the corners; empty where there are no seams
  EdgeChains chains;                ///< the same; for the user to move away
  std::vector<std::uint32_t> side;  ///< of each half-edge; kNone outside of the boundary
  std::vector<std::uint32_t> twin;  ///< of each side the one across; kNone at the boundary and at seams
  std::vector<std::uint32_t> face;  ///< of each vertex one that has it; kNone if there is none

  InputFaces() = default;
  /// \param mesh     of triangles
  /// \param numbers  as `corner_numbers` makes them
  template <typename Mesh>
  InputFaces(const Mesh& mesh, const std::vector<std::uint32_t>& numbers);

 private:
  /// Two sides of an edge with faces on both sides.
  void join(std::uint32_t s, std::uint32_t t);
};

template <typename Mesh>
InputFaces::InputFaces(const Mesh& mesh, const std::vector<std::uint32_t>& numbers)
    : side(mesh.n_halfedges(), kNone), twin(3 * mesh.n_faces(), kNone), face(mesh.n_vertices(), kNone) {
  const auto n = static_cast<std::uint32_t>(mesh.n_vertices());
  points.reserve(n + std::size_t{1});
  for (std::uint32_t v = 0; v < n; ++v) {
    const auto& p = mesh.point(typename Mesh::VertexHandle(static_cast<int>(v)));
    points.emplace_back(double(p[0]), double(p[1]), double(p[2]));
  }
  points.emplace_back(Eigen::Vector3d::Zero());
  triangles.assign(mesh.n_faces(), {n, n, n});
  if (!numbers.empty()) {
    wedges.assign(mesh.n_faces(), {0, 0, 0});
    chains = EdgeChains(mesh.n_faces());
  }
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    const typename Mesh::FaceHandle handle(static_cast<int>(f));
    if (mesh.has_face_status() && mesh.status(handle).deleted()) continue;
    auto h = mesh.halfedge_handle(handle);
    for (std::uint32_t k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
      const auto i = static_cast<std::size_t>(h.idx());
      const std::uint32_t end = k == 2 ? 0 : k + 1,
                          v = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      side[i] = 3 * f + k;
      triangles[f][end] = v;
      face[v] = f;
      if (!numbers.empty()) wedges[f][end] = numbers[i];
    }
  }
  for (std::size_t i = 0; i < side.size(); i += 2)
    if (side[i] != kNone && side[i + 1] != kNone) join(side[i], side[i + 1]);
}

inline void InputFaces::join(std::uint32_t s, std::uint32_t t) {
  bool agrees = true;
  if (!wedges.empty()) {
    const auto ends = [&](std::uint32_t at) {
      return std::array{std::size_t{at % 3}, std::size_t{at % 3 == 2 ? 0 : at % 3 + 1}};
    };
    const auto [s0, s1] = ends(s);
    const auto [t0, t1] = ends(t);
    const auto &at_s = wedges[s / 3], &at_t = wedges[t / 3];
    agrees = at_s[s0] == at_t[t1] && at_s[s1] == at_t[t0];
    const bool goes_up = triangles[s / 3][s0] < triangles[s / 3][s1];
    const auto key_s = goes_up ? std::tuple(at_s[s0], at_s[s1], s) : std::tuple(at_s[s1], at_s[s0], s);
    const auto key_t = goes_up ? std::tuple(at_t[t1], at_t[t0], t) : std::tuple(at_t[t0], at_t[t1], t);
    if (key_s < key_t)
      chains.link(s, t, agrees);
    else
      chains.link(t, s, agrees);
  }
  if (!agrees) return;
  twin[s] = t;
  twin[t] = s;
}

}  // namespace whittle::detail
