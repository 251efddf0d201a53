/// \file
/// FASS: FAD, then SS on what is left.
#pragma once

#include "whittle/plan/Stages.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/SphereScan.hh"

namespace whittle {

/// Planner of FASS (Paper 1, III.V.II): FAD removes the vertices of nearly flat places, then SS, planned anew
/// on the surface that FAD leaves, merges what its sphere covers. All collapses of FAD come before those of
/// SS.
struct Fass {
  FaceAngle face_angle;
  SphereScan sphere_scan;

  /// \throw InvalidParameter  as the two planners.
  void validate() const {
    face_angle.validate();
    sphere_scan.validate();
  }

  bool moves_seams() const { return face_angle.moves_seams() || sphere_scan.moves_seams(); }

  /// Both planners with their thresholds multiplied by `factor`, in [0, 1].
  Fass scaled(double factor) const { return {face_angle.scaled(factor), sphere_scan.scaled(factor)}; }

  /// \throw InvalidParameter
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const {
    validate();
    StagesT<Real> stages(surface);
    stages.add(face_angle);
    stages.add(sphere_scan);
    return stages.take();
  }
};

}  // namespace whittle
