/// \file
/// One plan, every level of detail.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recipe/Recipe.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/SeamRecord.hh"
#include "whittle/surface/pieces.hh"

namespace whittle::recipe {

/// A plan of the error-ordered planner `mq` down to nothing. Every beginning of it is a coarser mesh, so any
/// level is had by carrying out as much of it as that takes, without planning again.
class Progression {
 public:
  /// The mesh and the givens' attributes must outlive it.
  /// \throw InvalidMesh, InvalidParameter, Cancelled  as run().
  explicit Progression(const IndexedMesh& mesh, const Givens& givens = {}, const Monitor& monitor = {});

  std::size_t most_faces() const { return mesh_.triangles.size(); }
  std::size_t least_faces() const { return least_; }

  /// The finest level of at most so many faces; where that would ruin what is free, as Recipe::force says, a finer one;
  /// or the coarsest that there is.
  /// \param with_refit  whether its vertices move to where its faces lie closest to the input
  Result at(std::size_t faces, bool with_refit = true) const;

 private:
  const IndexedMesh& mesh_;
  Givens givens_;
  std::vector<std::uint8_t> held_in_refit_;
  detail::SeamRecord seam_record_;
  Pieces pieces_;
  CollapsePlan plan_;
  std::size_t least_;
  double plan_seconds_ = 0;
};

}  // namespace whittle::recipe
