/// \file
/// Pieces of a mesh that vanish as a whole, and a target that leaves the others their share.
#pragma once

#include <vector>

#include "recipe/Recipe.hh"
#include "recipe/Stage.hh"
#include "whittle/plan/attainable.hh"
#include "whittle/surface/pieces.hh"

namespace whittle::recipe {

/// What a recipe says of the pieces, decided for a mesh.
struct PieceChoice {
  Pieces pieces;           ///< empty where neither the recipe nor a target asks for them
  std::vector<bool> goes;  ///< for each piece; empty where none goes
  Attainable attainable;   ///< the target, raised where it would ruin what is free
};

/// Chooses the pieces that vanish and the target of the others. The pieces that vanish are locked, and added to the
/// task's target, so that the stages leave them as they are until `remove_pieces`.
PieceChoice choose_pieces(const Recipe& recipe, Task& task);

/// Removes the pieces that have been chosen from the result and its attributes.
void remove_pieces(const IndexedMesh& mesh, const PieceChoice& choice, Result& result);

}  // namespace whittle::recipe
