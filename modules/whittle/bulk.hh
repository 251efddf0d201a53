/// \file
/// The shortest way from flat arrays to flat arrays: plan and execute in one call.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/execute.hh"
#include "whittle/plan/plan_mesh.hh"
#include "whittle/refit/refit.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle {

/// What `bulk` may be told besides the planner.
struct BulkOptions {
  /// How often the planner is run at most, each time on what the last run leaves; >= 1. A planner that needs
  /// no surface, as MemorylessQuadric, is run once.
  std::size_t passes = 1;
  /// Stop as soon as no more faces are left; of the last pass only as many collapses are executed as it
  /// takes.
  std::size_t min_faces = 0;
  /// Whether the vertices move at the end to where the faces fit the input best; see `refit`. Without a value: as the
  /// planner has it, that is with MemorylessQuadric unless it keeps a bound.
  std::optional<bool> refit;
  /// For the parts that allow it. 0: as many as the machine runs at once. The result is the same
  /// for any number.
  std::size_t threads = 0;
  SurfaceExtras extras;  ///< locks, tolerances
};

/// What `bulk` makes of a mesh.
template <typename Real>
struct BulkResultT : ExecutedT<Real> {
  PlanRecord record;
  std::size_t collapses = 0, passes = 0;
  RefitReport refit;
};

/// Plans on a mesh and carries the plan out. The draft has tested every collapse for the link condition, so
/// what was manifold stays so and nothing needs repair. For OpenMesh meshes see `to_indexed` and
/// `to_openmesh`; to keep attributes and properties there, use `decimate`.
/// \throw InvalidMesh       an index out of range, a coordinate that is not finite.
/// \throw InvalidParameter  of the planner or of the options.
/// \throw NotReady          the planner has no threshold, target or bound, and `min_faces` is 0.
template <typename Planner, typename Real>
BulkResultT<Real> bulk(const Planner& planner, const IndexedMeshT<Real>& mesh, BulkOptions options = {}) {
  if (!detail::has_end(planner) && options.min_faces == 0)
    throw NotReady(
        "bulk: nothing says where to stop: give the planner a target or a bound, or set min_faces");
  if (options.passes == 0) throw InvalidParameter("the number of passes must be at least 1");
  const bool with_refit = detail::wants_refit(planner, options.refit);
  SurfaceExtras held;
  if (with_refit) held = detail::held_part(options.extras);
  // A planner that needs no surface goes as far as it can in one pass.
  const std::size_t passes = detail::plans_without_surface<Planner, Real>::value ? 1 : options.passes;
  const RepeatedPlan repeated =
      detail::plan_mesh(planner, mesh, std::move(options.extras), passes, options.threads,
                        [&](const auto& stages) { return stages.n_faces() <= options.min_faces; });
  BulkResultT<Real> out;
  std::size_t faces = mesh.triangles.size();
  for (const Collapse& collapse : repeated.plan.collapses) {
    if (faces <= options.min_faces) break;
    faces -= collapse.faces;
    ++out.collapses;
  }
  static_cast<ExecutedT<Real>&>(out) = execute(repeated.plan, mesh, out.collapses);
  out.record = repeated.plan.record;
  out.passes = repeated.passes;
  if (with_refit) out.refit = detail::refit_held(mesh, out, held, options.threads);
  return out;
}

}  // namespace whittle
