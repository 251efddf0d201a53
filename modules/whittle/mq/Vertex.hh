/// \file
/// What mq keeps of a vertex.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "whittle/surface/Surface.hh"

namespace whittle::mq {

using Vec = Eigen::Vector3f;

/// What every visit of a vertex reads; everything else lies in arrays of its own, so that more of these stay
/// in the cache.
struct Vertex {
  Vec position;
  std::uint32_t
      mark;  ///< when it was last near an edge that was judged; read as a fourth float with the three
};

/// Normals of faces, each of the length of twice the area, added up. Around a vertex: six times how fast the enclosed volume
/// grows as the vertex moves.
struct AreaVector {
  Vec sum = Vec::Zero();
  float pad = 0;  ///< read as a fourth float with the three
};

/// The flags of vertices that stay in place. A vertex on a seam stays where it is not known how the seam runs.
inline std::uint8_t held_flags(const SurfaceExtras& extras) {
  return extras.wedges.empty() ? kLocked | kFeature | kSeam : kLocked | kFeature;
}

/// Whether a vertex may move. At most one end of an edge that collapses is fixed, and none is untouchable.
enum Hold : std::uint8_t { kFree, kFixed, kUntouchable };

}  // namespace whittle::mq
