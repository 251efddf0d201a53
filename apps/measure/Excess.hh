/// \file
/// Where two surfaces lie farther apart than a bound.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "measure/Distance.hh"
#include "whittle/IndexedMesh.hh"

namespace whittle::measure {

/// The vertices of the faces on which a sample lies too far from the other surface, and the vertices that do
/// so themselves; each once, in ascending order.
struct Excess {
  std::vector<std::uint32_t> original, simplified;
  double max = 0;  ///< the largest distance of all, as in Distance::two_sided

  bool none() const { return original.empty() && simplified.empty(); }
};

/// Looks at the points that `distance` looks at.
/// \param bound  model units, not negative.
/// \throw  as distance().
Excess excess(const IndexedMesh& original, const IndexedMesh& simplified, double bound,
              const DistanceOptions& options = {});

}  // namespace whittle::measure
