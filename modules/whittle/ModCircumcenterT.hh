/// \file
/// VT as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/Circumcenter.hh"

namespace whittle {

/// Merges the vertices of triangles at their centres. The parameters are those of Circumcenter: `set_placement`,
/// `set_order`, `set_flip_guard`. VT has no threshold.
template <typename MeshT>
class ModCircumcenterT : public ModPlannedT<MeshT, Circumcenter> {
 public:
  DECIMATING_MODULE(ModCircumcenterT, MeshT, Circumcenter);

  explicit ModCircumcenterT(MeshT& mesh) : ModPlannedT<MeshT, Circumcenter>(mesh) {}
};

}  // namespace whittle
