/// \file
/// From the definition of a set to its mesh.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "recipe/Recipe.hh"
#include "results/Results.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

struct MadeSet {
  IndexedMesh mesh;
  double milliseconds = 0;        ///< of the simplifier, the fastest of three runs; of one where that is slow
  std::size_t flipped_faces = 0;  ///< turned by more than 90° against their own original; not known of a peer
};

/// What a set's recipe says; not of the original, a peer's set or a cache set.
/// \throw recipe::RecipeError  it means nothing
recipe::Recipe recipe_of(const SetDefinition& definition);

/// Makes the sets of one model, each once. The original must outlive it.
class SetMaker {
 public:
  explicit SetMaker(const IndexedMesh& original) : original_(original) {}

  /// The mesh of `definition`. The original is as it is in the file, in the file's order; a peer's set is
  /// brought to the triangle count of the set in `all` that it is compared with. Stays valid.
  /// \throw recipe::RecipeError, std::invalid_argument  a recipe that means nothing; an unknown peer; a set
  /// to compare with that is not in `all`.
  const MadeSet& make(const SetDefinition& definition, const std::vector<SetDefinition>& all);

 private:
  MadeSet make_anew(const SetDefinition& definition, const std::vector<SetDefinition>& all);

  const IndexedMesh& original_;
  std::map<std::string, MadeSet> made_;
};

}  // namespace whittle::bench
