/// \file
/// A recipe for each of several meshes that are one.
#pragma once

#include <cstdint>
#include <vector>

#include "recipe/Recipe.hh"

namespace whittle::recipe {

/// Runs a recipe on each body of a mesh for itself, as if the others were not there: a target holds for each.
/// \param body  for each face the body that it is of; bodies share no vertex
/// \return all of them together, with the stages of one body after those of another. A vertex of no face is gone
/// \throw  as run()
Result run_apart(const IndexedMesh& mesh, const std::vector<std::uint32_t>& body, const Recipe& recipe,
                 const Monitor& monitor = {}, const Givens& givens = {});

}  // namespace whittle::recipe
