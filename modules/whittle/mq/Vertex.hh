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

constexpr std::uint8_t kHeld = kLocked | kFeature | kSeam;  ///< flags of vertices that stay in place

/// Whether a vertex may move. At most one end of an edge that collapses is fixed, and none is untouchable.
enum Hold : std::uint8_t { kFree, kFixed, kUntouchable };

}  // namespace whittle::mq
