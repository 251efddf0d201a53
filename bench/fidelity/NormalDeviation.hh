/// \file
/// What distances do not see: the directions of the faces and their shapes.
#pragma once

#include <cstddef>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

/// Angles between the normals of simplified faces and of the original faces nearest to them.
struct NormalDeviation {
  double mean_degrees = 0;  ///< weighted by the faces' areas
  double max_degrees = 0;
};

/// Each simplified face is compared at its centroid and at the midpoints between centroid and corners, each
/// with the nearest face of the original. Faces without area are left out, on both sides.
/// \throw InvalidMesh  one of the meshes has no face of positive area.
NormalDeviation normal_deviation(const IndexedMesh& original, const IndexedMesh& simplified);

/// 4√3·area / (a² + b² + c²) over the faces: 1 is equilateral, 0 a needle.
struct TriangleQuality {
  double mean = 0;
  double p05 = 0;  ///< one face in twenty is worse
};
TriangleQuality triangle_quality(const IndexedMesh& mesh);

/// For each point of the original its distance to the simplified surface, for heat maps.
/// \throw InvalidMesh  as above.
std::vector<double> distances_to(const IndexedMesh& original, const IndexedMesh& simplified);

}  // namespace whittle::bench
