/// \file
/// How far a run has come.
#pragma once

#include <cstddef>
#include <optional>

#include "recipe/Recipe.hh"

namespace whittle::viewer {

/// The part of a run that is done, from 0 to 1; none where it is unknown: without a target a module goes as
/// far as its threshold takes it, mq plans in one go, a chain's modules share the way in no fixed parts, and
/// while a threshold is searched for, the mesh is decimated again and again.
/// \param before  triangles of the input.
std::optional<double> part_done(const recipe::Recipe& recipe, const recipe::Progress& now,
                                std::size_t before);

}  // namespace whittle::viewer
