/// \file
/// Where two surfaces lie farther apart than a bound.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "measure/Distance.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// A vertex that lies too far from the other surface itself, or has a face on which a sample does.
struct FarVertex {
  std::uint32_t vertex;
  double distance;  ///< the largest of those
};

struct Excess {
  std::vector<FarVertex> original, simplified;  ///< each vertex once, in ascending order
  double max = 0;                               ///< the largest distance of all, as in Distance::two_sided

  bool none() const { return original.empty() && simplified.empty(); }
};

/// Looks at the points that `distance` looks at.
/// \param bound  model units, not negative.
/// \throw  as distance().
Excess excess(const IndexedMesh& original, const IndexedMesh& simplified, double bound,
              const DistanceOptions& options = {}, const Monitor& monitor = {});

}  // namespace whittle::measure
