/// \file
/// IVDD as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/VertexDistance.hh"

namespace whittle {

/// Folds short edges and small triangles to a point. The parameters are those of VertexDistance; a setter
/// throws InvalidParameter and changes nothing when its value is out of range.
///
/// The survivors move, so stock binary modules judge a collapse as if they did not: ModNormalFlippingT sees
/// `v1` where it is before. The planner's own flip guard judges the final positions.
template <typename MeshT>
class ModVertexDistanceT : public ModPlannedT<MeshT, VertexDistance> {
 public:
  DECIMATING_MODULE(ModVertexDistanceT, MeshT, VertexDistance);

  explicit ModVertexDistanceT(MeshT& mesh) : ModPlannedT<MeshT, VertexDistance>(mesh) {}

  /// Edges shorter than this fold, in model units. >= 0; the default 0 folds nothing.
  void set_max_distance(double distance) {
    this->change([&](VertexDistance& p) { p.max_distance = distance; });
  }
  void set_placement(VertexDistance::Placement placement) {
    this->change([&](VertexDistance& p) { p.placement = placement; });
  }
  /// Default: by index, as in the paper.
  void set_order(ScanOrder order) {
    this->change([&](VertexDistance& p) { p.order = order; });
  }
  /// Default: boundary vertices stay.
  void set_boundary(Boundary boundary) {
    this->change([&](VertexDistance& p) { p.boundary = boundary; });
  }
  /// Least cosine between a face's new and original normal. -1..1, default 0.2; -1 turns the flip guard off.
  void set_flip_guard(double min_cos) {
    this->change([&](VertexDistance& p) { p.guard.min_cos = min_cos; });
  }
};

}  // namespace whittle
