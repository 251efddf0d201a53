/// \file
/// IVDD as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/VertexDistance.hh"

namespace whittle {

/// Folds short edges and small triangles to a point. The parameters are those of VertexDistance: beside the distance
/// `set_placement`, `set_order`, `set_boundary`, `set_seams` and `set_flip_guard`.
///
/// The survivors move, so stock binary modules judge a collapse as if they did not: ModNormalFlippingT sees
/// `v1` where it is before. The planner's own flip guard judges the final positions.
template <typename MeshT>
class ModVertexDistanceT : public ModPlannedT<MeshT, VertexDistance> {
 public:
  DECIMATING_MODULE(ModVertexDistanceT, MeshT, VertexDistance);

  explicit ModVertexDistanceT(MeshT& mesh) : ModPlannedT<MeshT, VertexDistance>(mesh) {}

  /// Edges shorter than this fold, in model units. >= 0. There is no default: without it, initialize() throws NotReady.
  void set_max_distance(double distance) {
    this->change([&](VertexDistance& p) { p.max_distance = distance; });
  }
};

}  // namespace whittle
