/// \file
/// Measures outcomes against their model.
#pragma once

#include <functional>
#include <memory>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "model/Model.hh"

namespace whittle::viewer {

/// Keeps the search tree of the last model, so that the next outcome of it is measured sooner. For use on one
/// thread at a time.
class Comparer {
 public:
  /// \param wanted  asked between the steps; false gives up.
  /// \return null if it gave up.
  std::shared_ptr<const Comparison> compare(std::shared_ptr<const Outcome> outcome,
                                            const std::function<bool()>& wanted);

 private:
  struct Tree {
    explicit Tree(const IndexedMesh& mesh) : surface(mesh), faces(surface, 0) {}
    measure::Surface surface;
    measure::ClosestFace faces;
  };
  bool add_heat(const Outcome& outcome, const std::function<bool()>& wanted, Comparison& comparison);

  std::shared_ptr<const Model> model_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace whittle::viewer
