/// \file
/// SS, spherical scanning: what a moving sphere covers becomes one vertex.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/plan/PlanDraft.hh"
#include "whittle/planners/PlaneQuadric.hh"
#include "whittle/planners/ScanOrder.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/triangle.hh"

namespace whittle {

/// Planner of SS (Paper 1, III.IV).
///
/// A sphere moves over the vertices in index order, or to where the error is least first. The neighbours of
/// the scanned vertex that lie in it merge with it, as far as they are free; a vertex merges at most once a
/// pass (*vertex lock*). If the whole is refused by the flip guard or the link condition, the nearest
/// neighbour alone is tried. The paper's "until all points are not in the same grid" is passes until nothing
/// changes: ModPlannedT::set_passes.
struct SphereScan {
  /// A neighbour must lie nearer than this. Model units, >= 0; 0 merges nothing. To be set: there is no default.
  std::optional<double> radius;
  enum class Placement {
    paper,   ///< two: midpoint; three: centre of the smallest enclosing circle; more: centroid
    quadric  ///< the point nearest to the planes of all faces around, weighted by area, at most half a radius
             ///< from there
  } placement = Placement::paper;
  ScanOrder order = ScanOrder::index;
  /// `merge`: boundary vertices merge with their neighbours on the boundary.
  Boundary boundary = Boundary::keep;
  /// `merge`: a vertex on a seam merges with the nearer of its neighbours along the seam.
  Seams seams = Seams::keep;
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  bool moves_seams() const { return seams == Seams::merge; }

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  SphereScan scaled(double factor) const {
    SphereScan planner = *this;
    if (radius) *planner.radius *= factor;
    return planner;
  }

  /// \throw InvalidParameter, NotReady  `radius` is not set.
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;

 private:
  /// The scanned vertex and the neighbours that it may merge with.
  struct Cluster {
    std::vector<std::uint32_t> members;
    std::uint32_t nearest = 0;
  };
  template <typename Real>
  void collect(const SurfaceT<Real>& surface, std::uint32_t v, const std::vector<std::uint8_t>& merged,
               Cluster& cluster) const;

  template <typename Real>
  Eigen::Vector3d place(const SurfaceT<Real>& surface, const std::vector<std::uint32_t>& members,
                        detail::HubPlanes& hubs) const;
};

inline void SphereScan::validate() const {
  if (radius && !(*radius >= 0 && std::isfinite(*radius)))
    throw InvalidParameter("SphereScan: the radius must be a finite length of at least 0");
  guard.validate();
}

template <typename Real>
Eigen::Vector3d SphereScan::place(const SurfaceT<Real>& surface, const std::vector<std::uint32_t>& members,
                                  detail::HubPlanes& hubs) const {
  const auto at = [&](std::size_t i) { return surface.point(members[i]); };
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : members) center += surface.point(v) / static_cast<double>(members.size());
  if (members.size() == 3) center = detail::enclosing_center(at(0), at(1), at(2));
  if (placement == Placement::paper || surface.is_on_seam(members[0])) return center;

  return detail::PlaneQuadric(surface, members, center, hubs).best(*radius / 2);
}

template <typename Real>
void SphereScan::collect(const SurfaceT<Real>& surface, std::uint32_t v,
                         const std::vector<std::uint8_t>& merged, Cluster& cluster) const {
  cluster.members.clear();
  if (merged[v] || !surface.is_free(v, boundary, seams)) return;
  cluster.members.push_back(v);
  double least = HUGE_VAL;
  const Ring ring = surface.ring(v);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::uint32_t w = ring[i];
    if (merged[w] || !surface.may_merge(v, w, boundary, seams)) continue;
    if (surface.is_boundary(v) && i > 0 && i + 1 < ring.size()) continue;  // not along the boundary
    const double reach = *radius * std::min(surface.tolerance(v), surface.tolerance(w));
    const double distance = (surface.point(w) - surface.point(v)).squaredNorm();
    if (!(distance < reach * reach)) continue;
    cluster.members.push_back(w);
    if (distance < least) {
      least = distance;
      cluster.nearest = w;
    }
  }
  if (surface.is_on_seam(v) && cluster.members.size() > 2) cluster.members = {v, cluster.nearest};
}

template <typename Real>
CollapsePlan SphereScan::plan(const SurfaceT<Real>& surface) const {
  validate();
  if (!radius)
    throw NotReady(
        "SphereScan: radius is not set: how near must neighbours be to merge? (set_radius of the module)");
  PlanDraftT<Real> draft(surface, guard);
  detail::HubPlanes hubs;
  std::vector<std::uint8_t> merged(surface.n_vertices(), false);
  Cluster cluster;
  std::vector<std::uint32_t>& members = cluster.members;
  using Verdict = typename PlanDraftT<Real>::Verdict;

  const auto cost = [&](std::uint32_t v) {
    collect(surface, v, merged, cluster);
    if (members.size() < 2) return HUGE_VAL;
    const Eigen::Vector3d target = place(surface, members, hubs);
    return detail::PlaneQuadric(surface, members, target, hubs).error(target);
  };
  detail::scan(surface.n_vertices(), order, cost, [&](std::uint32_t v) {
    collect(surface, v, merged, cluster);
    if (members.size() < 2) return;
    Verdict verdict = draft.merge(members, place(surface, members, hubs));
    if (verdict != Verdict::accepted && members.size() > 2) {
      members = {v, cluster.nearest};
      const Verdict second = draft.merge(members, place(surface, members, hubs));
      if (second == Verdict::accepted) {
        draft.count_fallback();
        verdict = second;
      }
    }
    draft.count_refusal(verdict);
    if (verdict == Verdict::accepted)
      for (const std::uint32_t w : members) merged[w] = true;
  });
  return draft.take();
}

}  // namespace whittle
