/// \file
/// How far two surfaces lie apart, sampled on both of them.
#pragma once

#include <cstddef>

#include "measure/Monitor.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// Distances in model units from the samples of one surface to the closest points of the other.
struct Deviation {
  double rms = 0, mean = 0;  ///< over the samples
  double max = 0;            ///< over the samples and all vertices: a spike's tip is met exactly
  std::size_t samples = 0;   ///< without the vertices
};

struct Distance {
  Deviation forward;    ///< from the original to the simplified surface
  Deviation backward;   ///< from the simplified to the original surface
  Deviation two_sided;  ///< rms and mean over both sides with equal weight; max is the larger (Hausdorff)
  double diagonal = 0;  ///< of the original's bounding box, to make the figures relative
  std::size_t flipped_faces = 0;  ///< simplified faces turned by more than 90 degrees against the original
                                  ///< face nearest to their centroid, or against all of them where several
                                  ///< are equally near; thin places can raise it by mistake
};

struct DistanceOptions {
  std::size_t samples = 200000;  ///< a side, spread evenly by area, besides every vertex
  unsigned threads = 0;          ///< 0: all cores; the result is the same for every number
};

/// Deterministic: samples come from a low-discrepancy sequence, sums are formed in a fixed order.
///
/// Degenerate faces (see MeshFacts) are left out on both sides, and with them the vertices that have no other
/// face.
///
/// \throw InvalidMesh  one of the meshes has no face of positive area, or a coordinate that is not finite.
///
/// The result does not depend on the monitor.
/// \throw InvalidParameter  the number of samples is 0.
/// \throw Cancelled  the monitor returned false: within some thousand samples, or while a search tree is built.
Distance distance(const IndexedMesh& original, const IndexedMesh& simplified,
                  const DistanceOptions& options = {}, const Monitor& monitor = {});

}  // namespace whittle::measure
