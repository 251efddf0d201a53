/// \file
/// VT as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/Circumcenter.hh"

namespace whittle {

/// Merges the vertices of triangles at their centres. The parameters are those of Circumcenter; a setter
/// throws InvalidParameter and changes nothing when its value is out of range.
template <typename MeshT>
class ModCircumcenterT : public ModPlannedT<MeshT, Circumcenter> {
 public:
  DECIMATING_MODULE(ModCircumcenterT, MeshT, Circumcenter);

  explicit ModCircumcenterT(MeshT& mesh) : ModPlannedT<MeshT, Circumcenter>(mesh) {}

  /// Default: the centre of the smallest enclosing circle.
  void set_placement(Circumcenter::Placement placement) {
    this->change([&](Circumcenter& p) { p.placement = placement; });
  }
  /// Default: by index, as in the paper.
  void set_order(ScanOrder order) {
    this->change([&](Circumcenter& p) { p.order = order; });
  }
  /// Least cosine between a face's new and original normal. -1..1, default 0.2; -1 turns the flip guard off.
  void set_flip_guard(double min_cos) {
    this->change([&](Circumcenter& p) { p.guard.min_cos = min_cos; });
  }
};

}  // namespace whittle
