/// \file
/// Vertices that stay because of where they lie: on the boundary, on a sharp edge.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/constants.hh"

namespace whittle::detail {

/// Locks the vertices of open edges.
template <typename Real>
void lock_boundary(const SurfaceT<Real>& surface, std::vector<std::uint8_t>& flags) {
  for (std::uint32_t v = 0; v < surface.n_vertices(); ++v)
    if (surface.is_boundary(v)) flags[v] |= kLocked;
}

/// Marks both ends of every edge whose two faces' normals differ by more than `degrees` as features. A face without
/// area has no normal and makes no feature.
template <typename Real>
void lock_features(const SurfaceT<Real>& surface, double degrees, std::vector<std::uint8_t>& flags) {
  const double least_cos = std::cos(degrees * (kPi / 180));
  for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
    const Ring ring = surface.ring(v);
    const std::size_t n = ring.n_faces();
    if (n == 0) continue;
    const Eigen::Vector3d p = surface.point(v);
    const auto normal = [&](std::size_t face) {
      return (surface.point(ring[face]) - p).cross(surface.point(ring[face + 1]) - p);
    };
    Eigen::Vector3d last = normal(ring.is_closed() ? n - 1 : 0);
    for (std::size_t i = ring.is_closed() ? 0 : 1; i < n;
         ++i) {  // the edge to ring[i], between faces i - 1 and i
      const Eigen::Vector3d next = normal(i);
      const double lengths = last.norm() * next.norm();
      if (lengths > 0 && last.dot(next) < least_cos * lengths) {
        flags[v] |= kFeature;
        flags[ring[i]] |= kFeature;
      }
      last = next;
    }
  }
}

}  // namespace whittle::detail
