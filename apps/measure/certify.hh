/// \file
/// The largest distance between two surfaces, proved for all of their points.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "measure/Monitor.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// The two-sided largest (Hausdorff) distance lies between `lower` and `upper`.
struct CertifiedDistance {
  double lower = 0, upper = 0;  ///< model units
  Eigen::Vector3d farthest;     ///< a point that is at least `lower` away from the other surface
  bool on_original = true;      ///< where that point lies
  std::size_t pieces = 0;       ///< faces and parts of faces looked at
};

/// Bounds the distance over *all* points of both surfaces, not over samples. Every face counts, degenerate ones, too;
/// vertices without a face do not.
/// \param tolerance  model units: what upper and lower bound differ by at most.
/// \param threads    0: all cores; the result is the same for every number.
/// \throw InvalidParameter  the tolerance is less than rounding makes of the coordinates: about 1e-13 of the largest.
/// \throw InvalidMesh       one of the meshes has no face, or a coordinate that is not finite.
/// \throw Cancelled         the monitor returned false.
CertifiedDistance certify(const IndexedMesh& original, const IndexedMesh& simplified, double tolerance,
                          unsigned threads = 0, const Monitor& monitor = {});

}  // namespace whittle::measure
