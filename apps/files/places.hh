/// \file
/// Which vertices stand at one place.
#pragma once

#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

/// For each vertex the first one at the same place: at equal coordinates, or itself. Coordinates that are not finite are
/// equal to none.
std::vector<std::uint32_t> equal_places(const std::vector<IndexedMesh::Point>& points);

/// The same for vertices no farther from each other than a distance. A chain of vertices, each within the distance of
/// the next, is one place as a whole.
/// \param distance  model units, positive
std::vector<std::uint32_t> near_places(const std::vector<IndexedMesh::Point>& points, double distance);

}  // namespace whittle::files
