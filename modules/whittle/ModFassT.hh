/// \file
/// FASS as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/Fass.hh"

namespace whittle {

/// FAD, then SS planned afresh on what is left (Paper 1, III.V.II). A setter throws InvalidParameter and
/// changes nothing when its value is out of range; `set_planner` reaches the other parameters of both.
template <typename MeshT>
class ModFassT : public ModPlannedT<MeshT, Fass> {
 public:
  DECIMATING_MODULE(ModFassT, MeshT, Fass);

  explicit ModFassT(MeshT& mesh) : ModPlannedT<MeshT, Fass>(mesh) {}

  /// Largest angle between the normals of two faces, in degrees. 0..180, default 30.
  void set_max_normal_angle(double degrees) {
    this->change([&](Fass& p) { p.face_angle.max_normal_angle = degrees; });
  }
  /// Neighbours nearer than this merge, in model units. >= 0. There is no default: without it, initialize() throws
  /// NotReady.
  void set_radius(double radius) {
    this->change([&](Fass& p) { p.sphere_scan.radius = radius; });
  }
  /// Of both. Default: boundary vertices stay.
  void set_boundary(Boundary boundary) {
    this->change([&](Fass& p) { p.face_angle.boundary = p.sphere_scan.boundary = boundary; });
  }
  /// Of both. Default: vertices on seams stay.
  void set_seams(Seams seams) {
    this->change([&](Fass& p) { p.face_angle.seams = p.sphere_scan.seams = seams; });
  }
  /// Of both. -1..1, default 0.2; -1 turns the flip guard off.
  void set_flip_guard(double min_cos) {
    this->change([&](Fass& p) { p.face_angle.guard.min_cos = p.sphere_scan.guard.min_cos = min_cos; });
  }
};

}  // namespace whittle
