/// \file
/// How far a point lies from the planes of the faces around some vertices.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "whittle/surface/Surface.hh"
#ifndef WHITTLE_COMPILED
#include <Eigen/Cholesky>
#endif

namespace whittle::detail {

/// Solves a x = b for a symmetric matrix. Eigen's decomposition takes a compiler longer than all the rest here.
#ifdef WHITTLE_COMPILED
Eigen::Vector3d solve(const Eigen::Matrix3d& a, const Eigen::Vector3d& b);
#else
inline Eigen::Vector3d solve(const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  return a.ldlt().solve(b);
}
#endif

/// The planes of the faces around vertices of very many faces, hubs, each summed once: every neighbour of a hub
/// may want to know.
class HubPlanes {
 public:
  static constexpr std::size_t kMany = 64;  ///< faces, of which a vertex with more is a hub

  /// The matrix of the quadric as seen from the vertex, through which all of its planes go.
  template <typename Real>
  const Eigen::Matrix3d& at(const SurfaceT<Real>& surface, std::uint32_t v) {
    const auto [known, is_new] = sums_.emplace(v, Eigen::Matrix3d::Zero());
    if (!is_new) return known->second;
    const Ring ring = surface.ring(v);
    const Eigen::Vector3d p = surface.point(v);
    for (std::size_t i = 0; i < ring.n_faces(); ++i) {
      const Eigen::Vector3d n = (surface.point(ring[i]) - p).cross(surface.point(ring[i + 1]) - p);
      const double length = n.norm();
      if (length > 0) known->second += n * n.transpose() / length;
    }
    return known->second;
  }

 private:
  std::unordered_map<std::uint32_t, Eigen::Matrix3d> sums_;
};

/// The sum over the faces of area times squared distance from the face's plane, as a function of a point;
/// twice that, to be exact. A face counts once for each of its corners among the vertices.
class PlaneQuadric {
 public:
  /// \param center  where the sum is seen from, to keep the numbers small.
  template <typename Real, typename Vertices>
  PlaneQuadric(const SurfaceT<Real>& surface, const Vertices& vertices, const Eigen::Vector3d& center,
               HubPlanes& hubs)
      : center_(center) {
    for (const std::uint32_t v : vertices) {
      const Ring ring = surface.ring(v);
      const Eigen::Vector3d p = surface.point(v);
      if (ring.n_faces() > HubPlanes::kMany) {
        const Eigen::Matrix3d& planes = hubs.at(surface, v);
        const Eigen::Vector3d offset = planes * (p - center);
        a_ += planes;
        b_ += offset;
        c_ += offset.dot(p - center);
        continue;
      }
      for (std::size_t i = 0; i < ring.n_faces(); ++i) {
        const Eigen::Vector3d n = (surface.point(ring[i]) - p).cross(surface.point(ring[i + 1]) - p);
        const double length = n.norm();
        if (!(length > 0)) continue;
        const double offset = n.dot(p - center);
        a_ += n * n.transpose() / length;
        b_ += n * (offset / length);
        c_ += offset * offset / length;
      }
    }
  }

  double error(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d x = point - center_;
    return std::max(0.0, x.dot(a_ * x) - 2 * b_.dot(x) + c_);
  }

  /// The point of least error, no further than `limit` from the center. A slight pull to the center decides
  /// where the planes leave a direction open.
  Eigen::Vector3d best(double limit) const {
    constexpr double kPull = 1e-5;  // as in mq
    const Eigen::Matrix3d a = a_ + kPull * a_.trace() * Eigen::Matrix3d::Identity();
    Eigen::Vector3d move = solve(a, b_);
    if (!move.allFinite()) return center_;
    if (move.norm() > limit) move *= limit / move.norm();
    return center_ + move;
  }

 private:
  Eigen::Vector3d center_;
  Eigen::Matrix3d a_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b_ = Eigen::Vector3d::Zero();
  double c_ = 0;
};

}  // namespace whittle::detail
