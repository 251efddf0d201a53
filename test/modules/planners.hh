/// \file
/// Planners with their one threshold set.
#pragma once

#include "whittle/FaceAngle.hh"
#include "whittle/SphereScan.hh"
#include "whittle/VertexDistance.hh"
#include "whittle/VertexTripletDistance.hh"

namespace planners {

inline whittle::VertexDistance ivdd(double distance) {
  whittle::VertexDistance planner;
  planner.max_distance = distance;
  return planner;
}

inline whittle::VertexTripletDistance vtd(double distance) {
  whittle::VertexTripletDistance planner;
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
