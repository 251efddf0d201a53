/// \file
/// FAD as an OpenMesh decimater module.
#pragma once

#include "whittle/openmesh/ModPlannedT.hh"
#include "whittle/planners/FaceAngle.hh"

namespace whittle {

/// Removes vertices whose faces lie nearly in a plane. The parameters are those of FaceAngle: beside those below
/// `set_boundary`, `set_seams` and `set_flip_guard`.
///
/// <!-- test: header_face_angle -->
/// \code
/// OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
/// whittle::ModFaceAngleT<Mesh>::Handle fad;
/// decimater.add(fad);
/// decimater.module(fad).set_max_normal_angle(30);
/// decimater.initialize();
/// decimater.decimate();
/// mesh.garbage_collection();
/// \endcode
template <typename MeshT>
class ModFaceAngleT : public ModPlannedT<MeshT, FaceAngle> {
 public:
  DECIMATING_MODULE(ModFaceAngleT, MeshT, FaceAngle);

  explicit ModFaceAngleT(MeshT& mesh) : ModPlannedT<MeshT, FaceAngle>(mesh) {}

  /// Largest angle between the normals of two faces, in degrees (Paper 1). 0..180, default 30.
  void set_max_normal_angle(double degrees) {
    this->change([&](FaceAngle& p) { p.max_normal_angle = degrees; });
  }
  /// The same threshold as an included angle, 180 degrees for a plane (Paper 2). 0..180, default 150.
  void set_min_included_angle(double degrees) { set_max_normal_angle(180 - degrees); }
  void set_pairs(FaceAngle::Pairs pairs) {
    this->change([&](FaceAngle& p) { p.pairs = pairs; });
  }
  /// How many of the angles must qualify; FaceAngle::kAllAngles, the default, for every one.
  void set_count(int count) {
    this->change([&](FaceAngle& p) { p.count = count; });
  }
  /// Largest area of the vertex's faces together, in square model units. Default: no bound.
  void set_max_area(double area) {
    this->change([&](FaceAngle& p) { p.max_area = area; });
  }
  void set_lock(FaceAngle::Lock lock) {
    this->change([&](FaceAngle& p) { p.lock = lock; });
  }
  void set_apex(FaceAngle::Apex apex) {
    this->change([&](FaceAngle& p) { p.apex = apex; });
  }
};

}  // namespace whittle
