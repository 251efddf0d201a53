/// \file
/// IVDD, intervertex distance dependence: short edges and small triangles fold to a point.
#pragma once

#include <cmath>
#include <cstdint>

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
  double max_distance = 0;  ///< model units, >= 0; an edge must be shorter than this. 0 folds nothing.
  using Placement = TrianglePlacement;
  Placement placement = Placement::enclosing;
  ScanOrder order = ScanOrder::index;
  Boundary boundary = Boundary::keep;  ///< `merge`: boundary edges fold to their midpoint
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  VertexDistance scaled(double factor) const {
    VertexDistance planner = *this;
    planner.max_distance *= factor;
    return planner;
  }

  /// \throw InvalidParameter
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;
};

inline void VertexDistance::validate() const {
  if (!(max_distance >= 0 && std::isfinite(max_distance)))
    throw InvalidParameter("VertexDistance: the distance must be a finite length of at least 0");
  guard.validate();
}

template <typename Real>
CollapsePlan VertexDistance::plan(const SurfaceT<Real>& surface) const {
  validate();
  PlanDraftT<Real> draft(surface, guard);
  std::vector<std::uint8_t> folded(surface.n_vertices(), false);
  using Verdict = typename PlanDraftT<Real>::Verdict;

  const auto is_triangle = [&](const ShortEdges& edges, std::uint32_t f) {
    return edges.count >= 2 && !surface.is_boundary(surface.triangle(f)[0]);
  };
  const auto cost = [&](std::uint32_t f) {
    const ShortEdges edges(surface, f, max_distance, boundary, folded);
    if (edges.count == 0) return HUGE_VAL;
    const auto error = [&](const auto& members) {
      const Eigen::Vector3d target = place(surface, members, placement);
      return PlaneQuadric(surface, members, target).error(target);
    };
    return is_triangle(edges, f) ? error(surface.triangle(f)) : error(edges.ends(surface.triangle(f)));
  };
  scan(surface.n_faces(), order, cost, [&](std::uint32_t f) {
    const ShortEdges edges(surface, f, max_distance, boundary, folded);
    if (edges.count == 0) return;
    const auto& t = surface.triangle(f);
    const bool triangle = is_triangle(edges, f);
    if (triangle && draft.merge(t, place(surface, t, placement)) == Verdict::accepted) {
      folded[t[0]] = folded[t[1]] = folded[t[2]] = true;
      return;
    }
    const auto ends = edges.ends(t);
    const Verdict verdict = draft.merge(ends, place(surface, ends, placement));
    draft.count_refusal(verdict);
    if (verdict != Verdict::accepted) return;
    folded[ends[0]] = folded[ends[1]] = true;
    if (triangle) draft.count_fallback();
  });
  return draft.take();
}

}  // namespace whittle
