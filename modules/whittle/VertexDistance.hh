/// \file
/// IVDD, intervertex distance dependence: short edges and small triangles fold to a point.
#pragma once

#include <cmath>
#include <cstdint>

#include "whittle/PlanDraft.hh"
#include "whittle/ShortEdges.hh"
#include "whittle/Surface.hh"
#include "whittle/errors.hh"
#include "whittle/triangle.hh"

namespace whittle {

/// Planner of IVDD (Paper 1, III.III).
///
/// Triangles are scanned in index order. Where two or more edges between free vertices are shorter than
/// `max_distance`, the three vertices fold to the triangle's centre; else the shortest edge below it folds to
/// its midpoint. A vertex folds at most once a pass (*vertex lock*). A triangle that the flip guard or the
/// link condition refuses folds its shortest edge instead, if that is allowed.
struct VertexDistance {
  double max_distance = 0;  ///< model units, >= 0; an edge must be shorter than this. 0 folds nothing.
  enum class Placement {
    enclosing,    ///< centre of the smallest enclosing circle; never outside of the triangle
    circumcenter  ///< the paper's words; far off the surface for obtuse triangles, so the guard refuses many
  } placement = Placement::enclosing;
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

  for (std::uint32_t f = 0; f < surface.n_faces(); ++f) {
    const ShortEdges edges(surface, f, max_distance, boundary, folded);
    if (edges.count == 0) continue;

    const auto& t = surface.triangle(f);
    Verdict triangle = Verdict::accepted;
    if (edges.count >= 2 && !surface.is_boundary(t[0])) {
      const Eigen::Vector3d a = surface.point(t[0]), b = surface.point(t[1]), c = surface.point(t[2]);
      const bool literal = placement == Placement::circumcenter;
      triangle = draft.merge({t[0], t[1], t[2]}, literal ? circumcenter(a, b, c) : enclosing_center(a, b, c));
      if (triangle == Verdict::accepted) {
        folded[t[0]] = folded[t[1]] = folded[t[2]] = true;
        continue;
      }
    }
    const std::uint32_t a = t[edges.shortest], b = t[(edges.shortest + 1) % 3];
    const Verdict edge = draft.merge({a, b}, (surface.point(a) + surface.point(b)) / 2);
    if (edge == Verdict::accepted) {
      folded[a] = folded[b] = true;
      if (triangle != Verdict::accepted) draft.count_fallback();
    } else {
      draft.count_refusal(edge);
    }
  }
  return draft.take();
}

}  // namespace whittle
