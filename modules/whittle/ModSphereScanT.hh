/// \file
/// SS as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/SphereScan.hh"

namespace whittle {

/// Merges what a moving sphere covers. The parameters are those of SphereScan; a setter throws
/// InvalidParameter and changes nothing when its value is out of range. `set_passes(kUntilRest)` goes on
/// until nothing changes.
template <typename MeshT>
class ModSphereScanT : public ModPlannedT<MeshT, SphereScan> {
 public:
  DECIMATING_MODULE(ModSphereScanT, MeshT, SphereScan);

  explicit ModSphereScanT(MeshT& mesh) : ModPlannedT<MeshT, SphereScan>(mesh) {}

  /// Neighbours nearer than this merge, in model units. >= 0; the default 0 merges nothing.
  void set_radius(double radius) {
    this->change([&](SphereScan& p) { p.radius = radius; });
  }
  /// Default: the paper's midpoint, centre or centroid.
  void set_placement(SphereScan::Placement placement) {
    this->change([&](SphereScan& p) { p.placement = placement; });
  }
  /// Default: by index, as in the paper.
  void set_order(ScanOrder order) {
    this->change([&](SphereScan& p) { p.order = order; });
  }
  /// Default: boundary vertices stay.
  void set_boundary(Boundary boundary) {
    this->change([&](SphereScan& p) { p.boundary = boundary; });
  }
  /// Least cosine between a face's new and original normal. -1..1, default 0.2; -1 turns the flip guard off.
  void set_flip_guard(double min_cos) {
    this->change([&](SphereScan& p) { p.guard.min_cos = min_cos; });
  }
};

}  // namespace whittle
