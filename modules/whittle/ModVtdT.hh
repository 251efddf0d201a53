/// \file
/// VTD as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/Vtd.hh"

namespace whittle {

/// VT for small triangles, an edge fold for the others. The parameters are those of Vtd: beside the distance
/// and the fold `set_placement`, `set_boundary`, `set_seams` and `set_flip_guard`.
template <typename MeshT>
class ModVtdT : public ModPlannedT<MeshT, Vtd> {
 public:
  DECIMATING_MODULE(ModVtdT, MeshT, Vtd);

  explicit ModVtdT(MeshT& mesh) : ModPlannedT<MeshT, Vtd>(mesh) {}

  /// Edges shorter than this count, in model units. >= 0. There is no default: without it, initialize() throws NotReady.
  void set_max_distance(double distance) {
    this->change([&](Vtd& p) { p.max_distance = distance; });
  }
  /// Which edge folds where not all three are short. Default: the shortest.
  void set_fold(Vtd::Fold fold) {
    this->change([&](Vtd& p) { p.fold = fold; });
  }
};

}  // namespace whittle
