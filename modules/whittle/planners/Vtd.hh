/// \file
/// VTD, vertex triplex distance: VT for small triangles, an edge fold for the others.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/plan/PlanDraft.hh"
#include "whittle/planners/ShortEdges.hh"
#include "whittle/planners/TrianglePlacement.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// Planner of VTD (Paper 1, III.V.I).
///
/// Triangles are scanned in index order. Where all three edges are shorter than `max_distance`, the three
/// vertices become one as in VT; else, if an edge is shorter, an edge folds to its midpoint. A vertex merges
/// at most once a pass (*vertex lock*). A triangle that the flip guard or the link condition refuses folds its shortest edge
/// instead.
struct Vtd {
  /// An edge must be shorter than this. Model units, >= 0; 0 merges nothing. To be set: there is no default.
  std::optional<double> max_distance;
  enum class Fold {
    shortest,  ///< the shortest edge
    literal  ///< the paper's words: of the first short edge's two neighbours, the longer. Doubles the error.
  } fold = Fold::shortest;
  using Placement = TrianglePlacement;
  Placement placement = Placement::enclosing;
  Boundary boundary = Boundary::keep;  ///< `merge`: boundary edges fold to their midpoint
  Seams seams = Seams::keep;           ///< `merge`: seam edges fold to their midpoint
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  bool moves_seams() const { return seams == Seams::merge; }

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  Vtd scaled(double factor) const {
    Vtd planner = *this;
    if (max_distance) *planner.max_distance *= factor;
    return planner;
  }

  /// \throw InvalidParameter, NotReady  `max_distance` is not set.
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;

 private:
  /// The edge to fold, from corner i to the next.
  template <typename Real>
  std::size_t choose(const SurfaceT<Real>& surface, std::uint32_t face,
                     const detail::ShortEdges& edges) const;
};

inline void Vtd::validate() const {
  if (max_distance && !(*max_distance >= 0 && std::isfinite(*max_distance)))
    throw InvalidParameter("Vtd: the distance must be a finite length of at least 0");
  guard.validate();
}

template <typename Real>
std::size_t Vtd::choose(const SurfaceT<Real>& surface, std::uint32_t face,
                        const detail::ShortEdges& edges) const {
  if (fold == Fold::shortest) return static_cast<std::size_t>(edges.shortest);
  // The paper asks for d12, then d13, then d23; here these are the edges 0, 2 and 1.
  const std::size_t first = edges.is_short[0] ? 0 : edges.is_short[2] ? 2 : 1;
  const std::size_t next = (first + 1) % 3, previous = (first + 2) % 3;
  const auto& t = surface.triangle(face);
  const Eigen::Vector3d p = surface.point(t[previous]);  // the corner that both of them have
  const double to_next = (p - surface.point(t[next])).squaredNorm();
  return (p - surface.point(t[first])).squaredNorm() >= to_next ? previous : next;
}

template <typename Real>
CollapsePlan Vtd::plan(const SurfaceT<Real>& surface) const {
  validate();
  if (!max_distance)
    throw NotReady(
        "Vtd: max_distance is not set: how short must an edge be to count? (set_max_distance of the module)");
  PlanDraftT<Real> draft(surface, guard);
  detail::HubPlanes hubs;
  std::vector<std::uint8_t> merged(surface.n_vertices(), false);
  using Verdict = typename PlanDraftT<Real>::Verdict;

  for (std::uint32_t f = 0; f < surface.n_faces(); ++f) {
    const detail::ShortEdges edges(surface, f, *max_distance, boundary, seams, merged);
    if (edges.count == 0) continue;

    const auto& t = surface.triangle(f);
    Verdict triangle = Verdict::accepted;
    std::size_t edge = 0;
    if (edges.count == 3 && !surface.is_boundary(t[0]) && !surface.is_on_seam(t[0])) {
      triangle = draft.merge(t, detail::place(surface, t, placement, hubs));
      if (triangle == Verdict::accepted) {
        merged[t[0]] = merged[t[1]] = merged[t[2]] = true;
        continue;
      }
      edge = static_cast<std::size_t>(edges.shortest);
    } else {
      edge = choose(surface, f, edges);
    }
    const std::uint32_t a = t[edge], b = t[(edge + 1) % 3];
    if (merged[a] || merged[b] || !surface.may_merge(a, b, boundary, seams))
      continue;  // literal: the edge is not short itself
    const std::array<std::uint32_t, 2> ends{a, b};
    const Verdict verdict = draft.merge(ends, detail::place(surface, ends, placement, hubs));
    draft.count_refusal(verdict);
    if (verdict != Verdict::accepted) continue;
    merged[a] = merged[b] = true;
    if (triangle != Verdict::accepted) draft.count_fallback();
  }
  return draft.take();
}

}  // namespace whittle
