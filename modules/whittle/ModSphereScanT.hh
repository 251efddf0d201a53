/// \file
/// SS as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/SphereScan.hh"

namespace whittle {

/// Merges what a moving sphere covers. The parameters are those of SphereScan: beside the radius `set_placement`,
/// `set_order`, `set_boundary`, `set_seams` and `set_flip_guard`. `set_passes(kUntilRest)` goes on until nothing
/// changes.
template <typename MeshT>
class ModSphereScanT : public ModPlannedT<MeshT, SphereScan> {
 public:
  DECIMATING_MODULE(ModSphereScanT, MeshT, SphereScan);

  explicit ModSphereScanT(MeshT& mesh) : ModPlannedT<MeshT, SphereScan>(mesh) {}

  /// Neighbours nearer than this merge, in model units. >= 0. There is no default: without it, initialize() throws
  /// NotReady.
  void set_radius(double radius) {
    this->change([&](SphereScan& p) { p.radius = radius; });
  }
};

}  // namespace whittle
