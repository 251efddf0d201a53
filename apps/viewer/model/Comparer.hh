/// \file
/// Measures outcomes against their model.
#pragma once

#include <functional>
#include <memory>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/Watch.hh"
#include "model/Model.hh"

namespace whittle::viewer {

/// Keeps the search tree of the last model, so that the next outcome of it is measured sooner. For use on one
/// thread at a time.
class Comparer {
 public:
  /// \return null if the monitor gave up.
  std::shared_ptr<const Comparison> compare(const std::shared_ptr<const Outcome>& outcome,
                                            const measure::Monitor& monitor = {});

 private:
  struct Tree {
    Tree(const IndexedMesh& mesh, const std::function<bool()>& go_on)
        : surface(mesh), faces(surface, 0, go_on) {}
    measure::Surface surface;
    measure::ClosestFace faces;
  };
  void add_heat(const Outcome& outcome, measure::Watch& watch, Comparison& comparison);

  std::shared_ptr<const Model> model_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace whittle::viewer
