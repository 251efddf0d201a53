/// \file
/// IVDD, intervertex distance dependence: short edges and small triangles fold to a point.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "whittle/plan/PlanDraft.hh"
#include "whittle/planners/ScanOrder.hh"
#include "whittle/planners/ShortEdges.hh"
#include "whittle/planners/TrianglePlacement.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// Planner of IVDD (Paper 1, III.III).
///
/// Triangles are scanned in index order, or the one of least error first. Where two or more edges between
/// free vertices are shorter than `max_distance`, the three vertices fold to the triangle's centre; else the
/// shortest edge below it folds to its midpoint. A vertex folds at most once a pass (*vertex lock*). A
/// triangle that the flip guard or the link condition refuses folds its shortest edge instead, if that is
/// allowed.
struct VertexDistance {
  /// An edge must be shorter than this. Model units, >= 0; 0 folds nothing. To be set: there is no default.
  std::optional<double> max_distance;
  using Placement = TrianglePlacement;
  Placement placement = Placement::enclosing;
  ScanOrder order = ScanOrder::index;
  Boundary boundary = Boundary::keep;  ///< `merge`: boundary edges fold to their midpoint
  Seams seams = Seams::keep;           ///< `merge`: seam edges fold to their midpoint
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  bool moves_seams() const { return seams == Seams::merge; }

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  VertexDistance scaled(double factor) const {
    VertexDistance planner = *this;
    if (max_distance) *planner.max_distance *= factor;
    return planner;
  }

  /// \throw InvalidParameter, NotReady  `max_distance` is not set.
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;
};

inline void VertexDistance::validate() const {
  if (max_distance && !(*max_distance >= 0 && std::isfinite(*max_distance)))
    throw InvalidParameter("VertexDistance: the distance must be a finite length of at least 0");
  guard.validate();
}

template <typename Real>
CollapsePlan VertexDistance::plan(const SurfaceT<Real>& surface) const {
  validate();
  if (!max_distance)
    throw NotReady(
        "VertexDistance: max_distance is not set: how short must an edge be to fold? (set_max_distance of "
        "the module)");
  PlanDraftT<Real> draft(surface, guard);
  detail::HubPlanes hubs;
  std::vector<std::uint8_t> folded(surface.n_vertices(), false);
  using Verdict = typename PlanDraftT<Real>::Verdict;

  const auto is_triangle = [&](const detail::ShortEdges& edges, std::uint32_t f) {
    const std::uint32_t v = surface.triangle(f)[0];  // all three are on a line, or none
    return edges.count >= 2 && !surface.is_boundary(v) && !surface.is_on_seam(v);
  };
  const auto cost = [&](std::uint32_t f) {
    const detail::ShortEdges edges(surface, f, *max_distance, boundary, seams, folded);
    if (edges.count == 0) return HUGE_VAL;
    const auto error = [&](const auto& members) {
      const Eigen::Vector3d target = detail::place(surface, members, placement, hubs);
      return detail::PlaneQuadric(surface, members, target, hubs).error(target);
    };
    return is_triangle(edges, f) ? error(surface.triangle(f)) : error(edges.ends(surface.triangle(f)));
  };
  detail::scan(surface.n_faces(), order, cost, [&](std::uint32_t f) {
    const detail::ShortEdges edges(surface, f, *max_distance, boundary, seams, folded);
    if (edges.count == 0) return;
    const auto& t = surface.triangle(f);
    const bool triangle = is_triangle(edges, f);
    if (triangle && draft.merge(t, detail::place(surface, t, placement, hubs)) == Verdict::accepted) {
      folded[t[0]] = folded[t[1]] = folded[t[2]] = true;
      return;
    }
    const auto ends = edges.ends(t);
    const Verdict verdict = draft.merge(ends, detail::place(surface, ends, placement, hubs));
    draft.count_refusal(verdict);
    if (verdict != Verdict::accepted) return;
    folded[ends[0]] = folded[ends[1]] = true;
    if (triangle) draft.count_fallback();
  });
  return draft.take();
}

}  // namespace whittle
