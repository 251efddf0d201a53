/// \file
/// A recipe's modules in the groups that run together, and the run of one such stage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recipe/Catalogue.hh"
#include "recipe/Recipe.hh"
#include "whittle/plan/TargetCount.hh"

namespace whittle::recipe {

/// A module that decimates, with the constraints that joined it and the driver that runs it.
struct Stage {
  Spec module;
  std::vector<Spec> constraints;
  Driver driver = Driver::bulk;
  std::size_t index = 0;  ///< among the stages, from 0

  bool is_planned() const { return find_module(module.name).role == Role::planned; }
  std::string text() const;  ///< "fad:angle=30 + normal-flipping"
};

/// \throw RecipeError  no module, a constraint in first place, a driver that cannot run a stage.
std::vector<Stage> stages_of(const Recipe& recipe);

/// The flags that keep a vertex in place through all of the stages: kSeam too, where none of them moves seams.
std::uint8_t flags_that_hold(const std::vector<Stage>& stages);

/// A recipe applied to a mesh: what its stages share.
struct Task {
  const IndexedMesh& mesh;
  std::vector<Stage> stages;
  Scale scale;
  TargetCount target;
  std::size_t samples;   ///< of a measured distance, on each side
  SurfaceExtras extras;  ///< of the mesh
  Monitor monitor;

  bool is_target_met(const IndexedMesh& result) const {
    return target.is_met(result.triangles.size(), result.points.size());
  }

  /// Tells the monitor how many faces are left. \return false: it ends the run.
  bool goes_on(const Stage& stage, std::size_t faces) const {
    return !monitor || monitor({stage.index, stages.size(), faces});
  }
};

/// The plan of a stage for a mesh: all its passes in one plan, so that the flip guard judges them together, or
/// a single pass where constraints have a say in what the next one finds.
RepeatedPlan plan_stage(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                        const SurfaceExtras& extras);

/// The shortest beginning of a plan that reaches the target, or all of it.
std::size_t collapses_to_target(const CollapsePlan& plan, const IndexedMesh& mesh, const TargetCount& target);

/// Gives a stage that has a target and no threshold the least threshold that reaches the target; the largest
/// sensible one if none does. Other stages stay as they are.
void find_threshold(const Task& task, Stage& stage, const IndexedMesh& mesh, const SurfaceExtras& extras);

/// Where to look for a threshold: from `first`, doubling, up to `last`.
struct ThresholdRange {
  double first, last;
};
ThresholdRange threshold_range(const Module& module, const Scale& scale);

/// Runs a stage on what those before it have left, and adds what it did.
/// \param extras  of `now.mesh`; carried along
StageResult run_stage(const Task& task, Stage stage, Decimated& now, SurfaceExtras& extras);

/// Runs all stages.
Result run_stages(const Task& task);

/// The same within a bound on the distance to the input, in model units. Modules that go by error stop where
/// the bound is met; a module without a threshold or target gets the largest threshold that keeps it, or a
/// larger one with some vertices held; with a threshold, the vertices around each place that lies too far are
/// held where they are, and all is run again, until no such place is left.
Result run_bounded(const Task& task, double bound);

}  // namespace whittle::recipe
