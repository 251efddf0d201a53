/// \file
/// VTD as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/Vtd.hh"

namespace whittle {

/// VT for small triangles, an edge fold for the others. The parameters are those of Vtd; a
/// setter throws InvalidParameter and changes nothing when its value is out of range.
template <typename MeshT>
class ModVtdT : public ModPlannedT<MeshT, Vtd> {
 public:
  DECIMATING_MODULE(ModVtdT, MeshT, Vtd);

  explicit ModVtdT(MeshT& mesh) : ModPlannedT<MeshT, Vtd>(mesh) {}

  /// Edges shorter than this count, in model units. >= 0; the default 0 merges nothing.
  void set_max_distance(double distance) {
    this->change([&](Vtd& p) { p.max_distance = distance; });
  }
  /// Which edge folds where not all three are short. Default: the shortest.
  void set_fold(Vtd::Fold fold) {
    this->change([&](Vtd& p) { p.fold = fold; });
  }
  /// Where three vertices merge. Default: the centre of the smallest enclosing circle.
  void set_placement(Vtd::Placement placement) {
    this->change([&](Vtd& p) { p.placement = placement; });
  }
  /// Default: boundary vertices stay.
  void set_boundary(Boundary boundary) {
    this->change([&](Vtd& p) { p.boundary = boundary; });
  }
  /// Least cosine between a face's new and original normal. -1..1, default 0.2; -1 turns the flip guard off.
  void set_flip_guard(double min_cos) {
    this->change([&](Vtd& p) { p.guard.min_cos = min_cos; });
  }
};

}  // namespace whittle
