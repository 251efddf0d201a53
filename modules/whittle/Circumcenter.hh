/// \file
/// VT, vertex triplex: triangles become points.
#pragma once

#include <cstdint>
#include <vector>

#include "whittle/PlanDraft.hh"
#include "whittle/Surface.hh"
#include "whittle/triangle.hh"

namespace whittle {

/// Planner of VT (Paper 1, III.I).
///
/// Triangles are scanned in index order. The vertices of a triangle whose three vertices are free become one.
/// A vertex merges at most once a pass (*vertex lock*); a triangle that the flip guard or the link condition
/// refuses is skipped. VT has no threshold, so `scaled` changes nothing; a vertex of tolerance 0 stays.
struct Circumcenter {
  enum class Placement {
    enclosing,  ///< centre of the smallest enclosing circle: the circumcentre of an acute triangle, else the
                ///< middle of the longest edge
    circumcenter  ///< the paper's words; far off the surface for obtuse triangles, so the guard refuses many
  } placement = Placement::enclosing;
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
  std::vector<std::uint8_t> merged(surface.n_vertices(), false);
  const auto is_free = [&](std::uint32_t v) { return surface.is_free(v) && !merged[v]; };

  for (std::uint32_t f = 0; f < surface.n_faces(); ++f) {
    const auto& t = surface.triangle(f);
    if (!is_free(t[0]) || !is_free(t[1]) || !is_free(t[2])) continue;
    const Eigen::Vector3d a = surface.point(t[0]), b = surface.point(t[1]), c = surface.point(t[2]);
    const bool literal = placement == Placement::circumcenter;
    const auto verdict =
        draft.merge({t[0], t[1], t[2]}, literal ? circumcenter(a, b, c) : enclosing_center(a, b, c));
    draft.count_refusal(verdict);
    if (verdict == PlanDraftT<Real>::Verdict::accepted) merged[t[0]] = merged[t[1]] = merged[t[2]] = true;
  }
  return draft.take();
}

}  // namespace whittle
