/// \file
/// A planner of any algorithm.
#pragma once

#include <any>
#include <cstddef>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/Stages.hh"
#include "whittle/plan/plan_mesh.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::recipe {

/// Called after each pass with what the plan leaves; true ends the planning.
using Enough = std::function<bool(std::size_t faces, std::size_t vertices)>;

/// Holds a planner of the library by value and runs it in passes.
class Planner {
 public:
  template <typename P>
  explicit Planner(const P& planner) : planner_(planner), plan_(plan_with<P>) {}

  /// Plans up to `max_passes` passes, fewer where it is enough or a pass changes nothing; uses all cores where
  /// the algorithm can. The result is the same on any number of them.
  RepeatedPlan plan(const IndexedMesh& mesh, const SurfaceExtras& extras, std::size_t max_passes,
                    const Enough& enough) const {
    return plan_(planner_, mesh, extras, max_passes, enough);
  }

  /// The planner itself. \pre it is a P
  template <typename P>
  const P& as() const {
    return std::any_cast<const P&>(planner_);
  }

 private:
  using Plan = RepeatedPlan (*)(const std::any&, const IndexedMesh&, const SurfaceExtras&, std::size_t,
                                const Enough&);

  /// A planner whose first pass is planned already.
  template <typename P>
  struct Continued {
    const P& planner;
    mutable std::optional<CollapsePlan> first;

    template <typename Real>
    CollapsePlan plan(const SurfaceT<Real>& surface) const {
      return first ? *std::exchange(first, std::nullopt) : planner.plan(surface);
    }
  };

  template <typename P>
  static RepeatedPlan plan_with(const std::any& held, const IndexedMesh& mesh, const SurfaceExtras& extras,
                                std::size_t max_passes, const Enough& enough) {
    const P& planner = std::any_cast<const P&>(held);
    const std::size_t n_threads = std::thread::hardware_concurrency();
    const auto done = [&](const auto& stages) { return enough(stages.n_faces(), stages.n_vertices()); };
    if constexpr (detail::plans_without_surface<P, double>::value) {
      CollapsePlan first = planner.plan(mesh, extras, n_threads);
      std::size_t faces = mesh.triangles.size();
      for (const Collapse& collapse : first.collapses) faces -= collapse.faces;
      if (max_passes == 1 || enough(faces, mesh.points.size() - first.collapses.size()))
        return {std::move(first), 1};
      return plan_passes(Continued<P>{planner, std::move(first)}, SurfaceT<double>(mesh, extras, n_threads),
                         max_passes, done);
    } else {
      return plan_passes(planner, SurfaceT<double>(mesh, extras, n_threads), max_passes, done);
    }
  }

  std::any planner_;
  Plan plan_;
};

}  // namespace whittle::recipe
