/// \file
/// A planner run on flat arrays, with a surface only where it needs one.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/Stages.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/threads.hh"

namespace whittle::detail {

/// Whether a planner has `plan(mesh, extras, n_threads)` and so can do without a surface, as
/// MemorylessQuadric.
template <typename Planner, typename Real, typename = void>
struct plans_without_surface : std::false_type {};
template <typename Planner, typename Real>
struct plans_without_surface<Planner, Real,
                             std::void_t<decltype(std::declval<const Planner&>().plan(
                                 std::declval<const IndexedMeshT<Real>&>(), SurfaceExtras(), std::size_t{}))>>
    : std::true_type {};

/// Runs a planner up to `max_passes` times, as `plan_passes` does. A single pass builds no surface if the
/// planner needs none.
/// \param threads  0: as many as the machine runs at once. The plan is the same for any number.
/// \throw InvalidMesh, InvalidParameter  as the constructor of SurfaceT and the planner.
template <typename Planner, typename Real, typename Enough>
RepeatedPlan plan_mesh(const Planner& planner, const IndexedMeshT<Real>& mesh, SurfaceExtras extras,
                       std::size_t max_passes, std::size_t threads, Enough enough) {
  threads = thread_count(threads);
  if constexpr (plans_without_surface<Planner, Real>::value)
    if (max_passes == 1) return {planner.plan(mesh, std::move(extras), threads), 1};
  const SurfaceT<Real> surface(mesh, std::move(extras), threads);
  return plan_passes(planner, surface, max_passes, enough);
}

}  // namespace whittle::detail
