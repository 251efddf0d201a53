/// \file
/// IVDD, intervertex distance dependence: short edges and small triangles fold to a point.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "whittle/PlanDraft.hh"
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
  std::vector<bool> folded(surface.n_vertices(), false);
  const auto is_free = [&](std::uint32_t v) { return surface.is_free(v) && !folded[v]; };
  using Verdict = typename PlanDraftT<Real>::Verdict;
  const double limit = max_distance * max_distance;

  for (std::uint32_t f = 0; f < surface.n_faces(); ++f) {
    const auto& t = surface.triangle(f);
    int n_short = 0, shortest = -1;
    std::array<double, 3> length{};  // squared, of the edge from corner i to the next
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (!is_free(a) || !is_free(b)) continue;
      length[i] = (surface.point(b) - surface.point(a)).squaredNorm();
      if (!(length[i] < limit)) continue;
      ++n_short;
      if (shortest < 0 || length[i] < length[shortest]) shortest = i;
    }
    if (n_short == 0) continue;

    Verdict verdict = Verdict::accepted;
    if (n_short >= 2) {
      const Eigen::Vector3d a = surface.point(t[0]), b = surface.point(t[1]), c = surface.point(t[2]);
      verdict = draft.template merge<3>({t[0], t[1], t[2]}, placement == Placement::enclosing
                                                                ? enclosing_center(a, b, c)
                                                                : circumcenter(a, b, c));
      if (verdict == Verdict::accepted) {
        folded[t[0]] = folded[t[1]] = folded[t[2]] = true;
        continue;
      }
    }
    const Verdict refusal = verdict;
    const std::uint32_t a = t[shortest], b = t[(shortest + 1) % 3];
    verdict = draft.template merge<2>({a, b}, (surface.point(a) + surface.point(b)) / 2);
    if (verdict == Verdict::accepted) {
      folded[a] = folded[b] = true;
      if (refusal != Verdict::accepted) draft.count_fallback();
    } else {
      draft.count_refusal(verdict);
    }
  }
  return draft.take();
}

}  // namespace whittle
