/// \file
/// Passes of a stage until it is done, and the search for a threshold that reaches a target.
#pragma once

#include <cstddef>

#include "recipe/Pass.hh"

namespace whittle::recipe {

/// Adds a pass to those before it: maps composed, counts and times added.
void append(Pass& sum, Pass&& pass);

/// What is known of the vertices, after a pass: a vertex that others merged into has the flags of all of them
/// and the least of their tolerances.
SurfaceExtras carried(const SurfaceExtras& extras, const Pass& pass);

/// The sum of several passes.
struct Passes {
  Pass sum;
  std::size_t count = 0;
};

/// Plans and executes up to `job.max_passes` passes, fewer where the floor is reached or a pass changes
/// nothing. Without constraints all passes are one plan, so that the flip guard judges them together; with
/// constraints each pass is planned on what the last one was allowed to do.
Passes run_passes(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job);

/// No passes: the mesh itself.
Passes no_passes(const IndexedMesh& mesh);

/// The least threshold with which `job.max_passes` passes reach the floor; the largest sensible one if none
/// does.
double find_threshold(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job);

}  // namespace whittle::recipe
