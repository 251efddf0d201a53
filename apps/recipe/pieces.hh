/// \file
/// Pieces of a mesh that vanish as a whole, and a target that leaves the others their share.
#pragma once

#include "recipe/Recipe.hh"
#include "recipe/Stage.hh"
#include "whittle/planners/PieceChoice.hh"

namespace whittle::recipe {

/// Chooses the pieces that vanish and the target of the others. The pieces that vanish are locked, and added to the
/// task's target, so that the stages leave them as they are until `remove_pieces`.
detail::PieceChoice choose_pieces(const Recipe& recipe, Task& task);

/// Removes the pieces that have been chosen from the result and its attributes.
void remove_pieces(const IndexedMesh& mesh, const detail::PieceChoice& choice, Result& result);

}  // namespace whittle::recipe
