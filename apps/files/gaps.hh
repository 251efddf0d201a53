/// \file
/// Boundaries that nearly meet.
#pragma once

#include <cstddef>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

/// What a weld would close.
struct Gaps {
  std::size_t boundary_vertices = 0;
  std::size_t near = 0;  ///< of them, within `length` of another one
  double length = 0;     ///< a tenth of the boundary's mean edge, and at most what a weld may be. Model units
};

Gaps find_gaps(const IndexedMesh& mesh);

}  // namespace whittle::files
