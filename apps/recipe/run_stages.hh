/// \file
/// The stages of a recipe, one after the other, with and without a bound on the distance.
#pragma once

#include <optional>
#include <vector>

#include "recipe/Recipe.hh"
#include "recipe/Stage.hh"
#include "recipe/passes.hh"

namespace whittle::recipe {

/// What the stages are to do with which mesh.
struct Work {
  const IndexedMesh& mesh;
  std::vector<Stage> stages;
  Driver driver;
  Scale scale;
  Floor floor;
  SurfaceExtras extras;
  Monitor monitor;
};

/// A stage with all that is settled before it runs; a threshold that was found is added to its module.
struct ReadyStage {
  Stage stage;
  Driver driver;
  std::optional<Planner> planner;  ///< none for stock modules
  std::size_t max_passes = 1;

  Job job(const Work& work, std::size_t index) const;
};

ReadyStage prepare(const Work& work, std::size_t index, const IndexedMesh& mesh, const SurfaceExtras& extras);

/// What came of all stages.
struct Ran {
  Pass sum;
  std::vector<StageResult> stages;
};

Ran run_stages(const Work& work);

/// The same within a bound on the distance to the input.
struct BoundedRan : Ran {
  double distance = 0;
  bool held = true;               ///< false: nothing could be done to keep the bound
  bool stopped = false;           ///< going on would have broken it
  std::size_t held_vertices = 0;  ///< kept in place for its sake
};

/// Modules that go by error stop where the bound is met; a module without a threshold or target gets the
/// largest threshold that keeps it, or a larger one with some vertices held; with a threshold, the vertices
/// around each place that lies too far are held where they are, and all is run again, until no such place is
/// left. \param bound  model units
BoundedRan run_bounded(const Work& work, double bound);

}  // namespace whittle::recipe
