/// \file
/// FASS as an OpenMesh decimater module.
#pragma once

#include "whittle/FaceAngle.hh"
#include "whittle/ModChainT.hh"
#include "whittle/SphereScan.hh"

namespace whittle {

/// FAD, then SS planned afresh on what is left (Paper 1, III.V.II). A setter throws InvalidParameter and
/// changes nothing when its value is out of range; `change_planner<0>` reaches the other parameters of FAD,
/// `<1>` those of SS.
template <typename MeshT>
class ModFassT : public ModChainT<MeshT, FaceAngle, SphereScan> {
 public:
  DECIMATING_MODULE(ModFassT, MeshT, Fass);

  explicit ModFassT(MeshT& mesh) : ModChainT<MeshT, FaceAngle, SphereScan>(mesh) {}

  /// Largest angle between the normals of two faces, in degrees. 0..180, default 30.
  void set_max_normal_angle(double degrees) {
    this->template change_planner<0>([&](FaceAngle& p) { p.max_normal_angle = degrees; });
  }
  /// Neighbours nearer than this merge, in model units. >= 0; the default 0 merges nothing.
  void set_radius(double radius) {
    this->template change_planner<1>([&](SphereScan& p) { p.radius = radius; });
  }
  /// Of both. Default: boundary vertices stay.
  void set_boundary(Boundary boundary) {
    this->change([&](Chain<FaceAngle, SphereScan>& p) {
      std::get<0>(p.planners).boundary = std::get<1>(p.planners).boundary = boundary;
    });
  }
  /// Of both. -1..1, default 0.2; -1 turns the flip guard off.
  void set_flip_guard(double min_cos) {
    this->change([&](Chain<FaceAngle, SphereScan>& p) {
      std::get<0>(p.planners).guard.min_cos = std::get<1>(p.planners).guard.min_cos = min_cos;
    });
  }
};

}  // namespace whittle
