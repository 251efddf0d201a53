/// \file
/// What a driver asks of a module that has a plan.
#pragma once

#include "whittle/plan/CollapsePlan.hh"

namespace whittle {

/// A module that has a plan; through it a driver such as SweepDecimaterT gets at the plan of any module.
class PlannedModule {
 public:
  virtual ~PlannedModule() = default;
  /// The plan for the mesh as it is; made at the first call, and anew when a parameter or the mesh has changed.
  virtual const CollapsePlan& plan() = 0;
  /// Whether its own parameters say where to stop. Of Whittle's planners only mq, without a target or a bound, has no
  /// end of its own.
  virtual bool has_end() const = 0;
};

}  // namespace whittle
