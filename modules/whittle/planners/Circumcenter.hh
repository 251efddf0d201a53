/// \file
/// VT, vertex triplex: triangles become points.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "whittle/plan/PlanDraft.hh"
#include "whittle/planners/ScanOrder.hh"
#include "whittle/planners/TrianglePlacement.hh"
#include "whittle/surface/Surface.hh"

namespace whittle {

/// Planner of VT (Paper 1, III.I).
///
/// Triangles are scanned in index order, or the one of least error first. The vertices of a triangle whose
/// three vertices are free become one. A vertex merges at most once a pass (*vertex lock*); a triangle that
/// the flip guard or the link condition refuses is skipped. VT has no threshold, so `scaled` changes nothing;
/// a vertex of tolerance 0 stays.
struct Circumcenter {
  using Placement = TrianglePlacement;
  Placement placement = Placement::enclosing;
  ScanOrder order = ScanOrder::index;
  FlipGuard guard;

  /// \throw InvalidParameter  the guard's cosine is out of range.
  void validate() const { guard.validate(); }

  Circumcenter scaled(double /*factor*/) const { return *this; }

  /// \throw InvalidParameter
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;
};

template <typename Real>
CollapsePlan Circumcenter::plan(const SurfaceT<Real>& surface) const {
  validate();
  PlanDraftT<Real> draft(surface, guard);
  detail::HubPlanes hubs;
  std::vector<std::uint8_t> merged(surface.n_vertices(), false);
  const auto is_free = [&](std::uint32_t v) { return surface.is_free(v) && !merged[v]; };

  const auto is_open = [&](std::uint32_t f) {
    const auto& t = surface.triangle(f);
    return is_free(t[0]) && is_free(t[1]) && is_free(t[2]);
  };
  const auto cost = [&](std::uint32_t f) {
    if (!is_open(f)) return HUGE_VAL;
    const auto& t = surface.triangle(f);
    const Eigen::Vector3d target = detail::place(surface, t, placement, hubs);
    return detail::PlaneQuadric(surface, t, target, hubs).error(target);
  };
  detail::scan(surface.n_faces(), order, cost, [&](std::uint32_t f) {
    if (!is_open(f)) return;
    const auto& t = surface.triangle(f);
    const auto verdict = draft.merge(t, detail::place(surface, t, placement, hubs));
    draft.count_refusal(verdict);
    if (verdict == PlanDraftT<Real>::Verdict::accepted) merged[t[0]] = merged[t[1]] = merged[t[2]] = true;
  });
  return draft.take();
}

}  // namespace whittle
