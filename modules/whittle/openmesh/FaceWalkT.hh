/// \file
/// The nearest point of a mesh's faces, found by walking there from a face nearby.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "whittle/openmesh/describe.hh"
#include "whittle/surface/triangle.hh"

namespace whittle::detail {

/// The faces of an OpenMesh mesh as they were at the construction, each with its neighbours; seams of
/// half-edge texture coordinates part faces as the boundary does. Faces keep their indices, and corner
/// 3 f + i is corner i of face f. About 36 bytes a face and 24 a vertex.
template <typename Mesh>
class FaceWalkT {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// A point of a face: the corners' shares of it, which add up to 1.
  struct Spot {
    std::uint32_t face = kNone;
    std::array<double, 3> shares{1, 0, 0};
    double squares = HUGE_VAL;  ///< of the distance
  };

  FaceWalkT() = default;
  /// \param mesh  of triangles
  explicit FaceWalkT(const Mesh& mesh);

  std::uint32_t vertex(std::uint32_t corner) const { return vertex_[corner]; }
  /// A face that has the vertex; kNone if there is none.
  std::uint32_t a_face(std::uint32_t vertex) const { return face_[vertex]; }

  /// Goes from the nearest of a few faces to ever nearer ones, as long as there is one among those around the
  /// corners of the last. No seam is crossed on the way.
  /// \param starts  may be kNone
  Spot nearest(const Eigen::Vector3d& p, std::initializer_list<std::uint32_t> starts) const;

 private:
  static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static std::uint32_t previous(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

  void look(const Eigen::Vector3d& p, std::uint32_t face, Spot& best) const;
  void look_around(const Eigen::Vector3d& p, std::uint32_t corner, Spot& best) const;

  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint32_t> vertex_, twin_;  // of each corner; its edge goes on to the next corner
  std::vector<std::uint32_t> face_;           // of each vertex
};

template <typename Mesh>
FaceWalkT<Mesh>::FaceWalkT(const Mesh& mesh)
    : vertex_(3 * mesh.n_faces(), kNone), twin_(3 * mesh.n_faces(), kNone), face_(mesh.n_vertices(), kNone) {
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    const auto& p = mesh.point(typename Mesh::VertexHandle(static_cast<int>(v)));
    points_.emplace_back(double(p[0]), double(p[1]), double(p[2]));
  }
  std::vector<std::uint32_t> corner_of(mesh.n_halfedges(), kNone);
  for (std::uint32_t f = 0; f < mesh.n_faces(); ++f) {
    const typename Mesh::FaceHandle face(static_cast<int>(f));
    if (mesh.has_face_status() && mesh.status(face).deleted()) continue;
    auto h = mesh.halfedge_handle(face);
    for (std::uint32_t c = 3 * f; c < 3 * f + 3; ++c, h = mesh.next_halfedge_handle(h)) {
      vertex_[c] = static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx());
      face_[vertex_[c]] = f;
      corner_of[static_cast<std::size_t>(h.idx())] = c;
    }
  }
  for (std::size_t i = 0; i < corner_of.size(); ++i) {
    const std::uint32_t twin = corner_of[i ^ 1];
    if (corner_of[i] == kNone || twin == kNone) continue;
    if (!is_seam(mesh, typename Mesh::HalfedgeHandle(static_cast<int>(i)))) twin_[corner_of[i]] = twin;
  }
}

template <typename Mesh>
auto FaceWalkT<Mesh>::nearest(const Eigen::Vector3d& p, std::initializer_list<std::uint32_t> starts) const
    -> Spot {
  Spot best;
  for (const std::uint32_t face : starts) {
    if (face == kNone) continue;
    if (best.face == kNone) best.face = face;  // whatever its shape
    look(p, face, best);
  }
  for (std::uint32_t at = kNone; at != best.face;) {
    at = best.face;
    for (std::uint32_t corner = 3 * at; corner < 3 * at + 3; ++corner) look_around(p, corner, best);
  }
  return best;
}

template <typename Mesh>
void FaceWalkT<Mesh>::look(const Eigen::Vector3d& p, std::uint32_t face, Spot& best) const {
  const std::size_t first = std::size_t{3} * face;
  const Eigen::Vector3d &a = points_[vertex_[first]], &b = points_[vertex_[first + 1]],
                        &c = points_[vertex_[first + 2]];
  at_closest_point(p, a, b, c, [&](const Eigen::Vector3d& corner, const auto&... step) {
    Eigen::Vector3d offset = p - corner;
    ((offset -= step.share * step.side), ...);
    const double squares = offset.squaredNorm();
    if (!(squares < best.squares)) return;
    best = {face, {0, 0, 0}, squares};
    double rest = 1;
    [[maybe_unused]] const auto go = [&](std::size_t to, double share) {
      best.shares[to] += share;
      rest -= share;
    };
    if constexpr (sizeof...(step) == 2) {  // from a towards b and c
      std::size_t to = 1;
      (go(to++, step.share), ...);
    } else if constexpr (sizeof...(step) == 1) {  // along ab, ac or bc
      (go(&corner == &a && step.side == b - a ? 1 : 2, step.share), ...);
    }
    best.shares[&corner == &a ? 0 : &corner == &b ? 1 : 2] += rest;
  });
}

template <typename Mesh>
void FaceWalkT<Mesh>::look_around(const Eigen::Vector3d& p, std::uint32_t corner, Spot& best) const {
  std::uint32_t at = corner;
  while ((at = twin_[previous(at)]) != kNone) {
    if (at == corner) return;
    look(p, at / 3, best);
  }
  for (at = corner; (at = twin_[at]) != kNone;) look(p, (at = next(at)) / 3, best);
}

}  // namespace whittle::detail
