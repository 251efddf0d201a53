/// \file
/// What a driver asks of a module that has a plan.
#pragma once

#include <cstddef>

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
  /// Whether the target that its own parameters name, if any, is met by so many faces and vertices.
  virtual bool is_target_met(std::size_t n_faces, std::size_t n_vertices) const = 0;

  // A driver that carries the plan out alone, without asking any module for priorities, uses these.

  /// Whether the mesh still has the faces that the plan was made for, and no further locked or feature vertices. Then
  /// every planned collapse is legal in its turn.
  virtual bool is_fresh() const = 0;
  /// Whether it has something to do at each collapse, for the mesh's seams.
  virtual bool watches_collapses() const = 0;
  /// \param halfedge  its index in the mesh
  virtual void before_collapse(int halfedge) = 0;
  virtual void after_collapse(std::size_t rank) = 0;
  /// At the end, whether it watches them or not: the first so many collapses have been executed.
  virtual void after_collapses(std::size_t n) = 0;

  /// After the last collapse of a run, of any driver.
  /// \param only_selected  vertices that are not selected stay where they are
  virtual void finish(bool only_selected) = 0;
};

}  // namespace whittle
