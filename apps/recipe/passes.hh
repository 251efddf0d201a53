/// \file
/// Passes of a stage until it is done, and the search for a threshold that reaches a target.
#pragma once

#include <cstddef>

#include "recipe/Pass.hh"

namespace whittle::recipe {

/// Adds a pass to those before it: maps composed, counts and times added.
void append(Pass& sum, Pass&& pass);

/// The sum of several passes.
struct Passes {
  Pass sum;
  std::size_t count = 0;
};

/// Plans and executes up to `max_passes` passes, fewer where the floor is reached or a pass changes nothing.
/// Without constraints all passes are one plan, so that the flip guard judges them together; with constraints
/// each pass is planned on what the last one was allowed to do. \param planner  null for a stock module.
Passes run_passes(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner* planner,
                  const Scale& scale, const Floor& floor, std::size_t max_passes, const GoOn& go_on = {});

/// No passes: the mesh itself.
Passes no_passes(const IndexedMesh& mesh);

/// The least threshold with which `max_passes` passes reach the floor; the largest sensible one if none does.
double find_threshold(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner& planner,
                      const Scale& scale, const Floor& floor, std::size_t max_passes, const GoOn& go_on = {});

}  // namespace whittle::recipe
