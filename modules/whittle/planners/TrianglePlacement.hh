/// \file
/// Where the three vertices of a triangle, or the two of an edge, become one.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>

#include "whittle/planners/PlaneQuadric.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/triangle.hh"

namespace whittle {

enum class TrianglePlacement {
  enclosing,     ///< centre of the smallest enclosing circle: the circumcentre of an acute triangle, else the
                 ///< middle of the longest edge. Never outside of the triangle.
  circumcenter,  ///< the paper's words; far off the surface for obtuse triangles, so the guard refuses many
  quadric        ///< the point nearest to the planes of all faces around, no further from the centre of the
                 ///< enclosing circle than that circle's radius; of an edge likewise, from its middle
};

namespace detail {

/// Where the vertices of a triangle merge.
template <typename Real>
Eigen::Vector3d place(const SurfaceT<Real>& surface, const std::array<std::uint32_t, 3>& t,
                      TrianglePlacement placement, HubPlanes& hubs) {
  const Eigen::Vector3d a = surface.point(t[0]), b = surface.point(t[1]), c = surface.point(t[2]);
  if (placement == TrianglePlacement::circumcenter) return detail::circumcenter(a, b, c);
  Eigen::Vector3d center = detail::enclosing_center(a, b, c);
  if (placement == TrianglePlacement::enclosing) return center;
  const double radius = std::max({(a - center).norm(), (b - center).norm(), (c - center).norm()});
  return PlaneQuadric(surface, t, center, hubs).best(radius);
}

/// Where the ends of an edge merge. On the boundary and on seams always its middle, which keeps straight ones straight.
template <typename Real>
Eigen::Vector3d place(const SurfaceT<Real>& surface, const std::array<std::uint32_t, 2>& edge,
                      TrianglePlacement placement, HubPlanes& hubs) {
  const Eigen::Vector3d a = surface.point(edge[0]), b = surface.point(edge[1]);
  Eigen::Vector3d middle = (a + b) / 2;
  const bool on_line = surface.is_boundary(edge[0]) || surface.is_on_seam(edge[0]);
  if (placement != TrianglePlacement::quadric || on_line) return middle;
  return PlaneQuadric(surface, edge, middle, hubs).best((b - a).norm() / 2);
}

}  // namespace detail

}  // namespace whittle
