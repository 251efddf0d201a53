/// \file
/// What must hold of every simplified mesh, checked by counting.
#pragma once

#include <string>

#include "measure/MeshFacts.hh"
#include "recipe/Recipe.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::corpus {

/// A mesh and what was counted of it.
struct Counted {
  explicit Counted(IndexedMesh of) : mesh(std::move(of)), facts(measure::facts(mesh)) {}
  IndexedMesh mesh;
  measure::MeshFacts facts;
};

/// The mesh without the faces that OpenMesh cannot take.
IndexedMesh as_openmesh_takes_it(const IndexedMesh& mesh);

/// What does not hold of the result of `recipe`, separated by commas; empty if all does.
/// \param before  the input
/// \param taken   the input without the faces that OpenMesh cannot take: where the run left those out, genus,
///                pieces and boundary must be those of the rest
std::string broken(const Counted& before, const Counted& taken, const recipe::Recipe& recipe,
                   const recipe::Result& result);

}  // namespace whittle::corpus
