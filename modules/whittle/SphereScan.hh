/// \file
/// SS, spherical scanning: what a moving sphere covers becomes one vertex.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "whittle/PlanDraft.hh"
#include "whittle/Surface.hh"
#include "whittle/errors.hh"
#include "whittle/triangle.hh"

namespace whittle {

/// Planner of SS (Paper 1, III.IV).
///
/// A sphere moves over the vertices in index order. The neighbours of the scanned vertex that lie in it merge
/// with it, as far as they are free; a vertex merges at most once a pass (*vertex lock*). If the whole is
/// refused by the flip guard or the link condition, the nearest neighbour alone is tried. The paper's "until
/// all points are not in the same grid" is passes until nothing changes: ModPlannedT::set_passes.
struct SphereScan {
  double radius = 0;  ///< model units, >= 0; a neighbour must lie nearer than this. 0 merges nothing.
  enum class Placement {
    paper,   ///< two: midpoint; three: centre of the smallest enclosing circle; more: centroid
    quadric  ///< the point nearest to the planes of all faces around, weighted by area, at most half a radius
             ///< from there
  } placement = Placement::paper;
  Boundary boundary =
      Boundary::keep;  ///< `merge`: boundary vertices merge with their neighbours on the boundary
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  SphereScan scaled(double factor) const {
    SphereScan planner = *this;
    planner.radius *= factor;
    return planner;
  }

  /// \throw InvalidParameter
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;

 private:
  template <typename Real>
  Eigen::Vector3d place(const SurfaceT<Real>& surface, const std::vector<std::uint32_t>& members) const;
};

inline void SphereScan::validate() const {
  if (!(radius >= 0 && std::isfinite(radius)))
    throw InvalidParameter("SphereScan: the radius must be a finite length of at least 0");
  guard.validate();
}

template <typename Real>
Eigen::Vector3d SphereScan::place(const SurfaceT<Real>& surface,
                                  const std::vector<std::uint32_t>& members) const {
  const auto at = [&](std::size_t i) { return surface.point(members[i]); };
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : members) center += surface.point(v) / static_cast<double>(members.size());
  if (members.size() == 3) center = enclosing_center(at(0), at(1), at(2));
  if (placement == Placement::paper) return center;

  // Least sum of area * (distance to plane)^2, seen from `center`. The regularisation pulls to `center` where
  // the planes leave a direction open.
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : members) {
    const Ring ring = surface.ring(v);
    const Eigen::Vector3d p = surface.point(v);
    for (std::size_t i = 0; i < ring.n_faces(); ++i) {
      const Eigen::Vector3d n = (surface.point(ring[i]) - p).cross(surface.point(ring[i + 1]) - p);
      const double length = n.norm();
      if (!(length > 0)) continue;
      A += n * n.transpose() / length;
      b += n * (n.dot(p - center) / length);
    }
  }
  constexpr double kRegularisation = 1e-3;
  A += kRegularisation * A.trace() * Eigen::Matrix3d::Identity();
  Eigen::Vector3d move = A.ldlt().solve(b);
  if (!move.allFinite()) return center;
  if (move.norm() > radius / 2) move *= radius / 2 / move.norm();
  return center + move;
}

template <typename Real>
CollapsePlan SphereScan::plan(const SurfaceT<Real>& surface) const {
  validate();
  PlanDraftT<Real> draft(surface, guard);
  std::vector<std::uint8_t> merged(surface.n_vertices(), false);
  std::vector<std::uint32_t> members;
  using Verdict = typename PlanDraftT<Real>::Verdict;

  for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
    if (merged[v] || !surface.is_free(v, boundary)) continue;
    members.assign(1, v);
    std::uint32_t nearest = v;
    double least = HUGE_VAL;
    const Ring ring = surface.ring(v);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t w = ring[i];
      if (merged[w] || !surface.may_merge(v, w, boundary)) continue;
      if (surface.is_boundary(v) && i > 0 && i + 1 < ring.size()) continue;  // not along the boundary
      const double reach = radius * std::min(surface.tolerance(v), surface.tolerance(w));
      const double distance = (surface.point(w) - surface.point(v)).squaredNorm();
      if (!(distance < reach * reach)) continue;
      members.push_back(w);
      if (distance < least) {
        least = distance;
        nearest = w;
      }
    }
    if (members.size() < 2) continue;

    Verdict verdict = draft.merge(members, place(surface, members));
    if (verdict != Verdict::accepted && members.size() > 2) {
      members = {v, nearest};
      const Verdict second = draft.merge(members, place(surface, members));
      if (second == Verdict::accepted) {
        draft.count_fallback();
        verdict = second;
      }
    }
    draft.count_refusal(verdict);
    if (verdict == Verdict::accepted)
      for (const std::uint32_t w : members) merged[w] = true;
  }
  return draft.take();
}

}  // namespace whittle
