/// \file
/// Planners with their one threshold set.
#pragma once

#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

namespace planners {

inline whittle::VertexDistance ivdd(double distance) {
  whittle::VertexDistance planner;
  planner.max_distance = distance;
  return planner;
}

inline whittle::Vtd vtd(double distance) {
  whittle::Vtd planner;
  planner.max_distance = distance;
  return planner;
}

inline whittle::SphereScan ss(
    double radius, whittle::SphereScan::Placement placement = whittle::SphereScan::Placement::paper) {
  whittle::SphereScan planner;
  planner.radius = radius;
  planner.placement = placement;
  return planner;
}

inline whittle::FaceAngle fad(double degrees) {
  whittle::FaceAngle planner;
  planner.max_normal_angle = degrees;
  return planner;
}

}  // namespace planners
