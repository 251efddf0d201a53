/// \file
/// A plan while it is drawn up, and the surface as it will be once the plan so far is executed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <unordered_map>
#include <utility>
#include <vector>

#include "whittle/plan/ClustersT.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/FlipGuard.hh"
#include "whittle/plan/LinkConditionT.hh"
#include "whittle/surface/Surface.hh"

namespace whittle {

/// Adds clusters to a plan one after the other. Every cluster is tested on the surface as the earlier ones
/// leave it: for the link condition, so that executors find every planned collapse legal, and for the flip
/// guard.
template <typename Real>
class PlanDraftT {
 public:
  using Point = typename IndexedMeshT<Real>::Point;

  PlanDraftT(const SurfaceT<Real>& surface, FlipGuard guard)
      : surface_(surface), guard_(guard), clusters_(surface), links_(clusters_) {
    plan_.stages.push_back(0);
    plan_.collapses.reserve(2 * clusters_.size() / 3);  // as many as folds of triangles can make
  }

  /// What has become of a vertex; the vertex itself if it still stands.
  std::uint32_t survivor(std::uint32_t v) const { return clusters_.survivor(v); }

  /// Where a survivor lies.
  Eigen::Vector3d position(std::uint32_t survivor) const { return clusters_.position(survivor); }

  enum class Verdict { accepted, refused_by_link, refused_by_flip_guard };

  /// Merges `members` into the first of them, at `target`; all must be survivors and connected by edges to
  /// the first. Refused, nothing changes. The caller counts the refusal with `count_refusal`, for it may have
  /// another proposal for the same place.
  Verdict merge(std::initializer_list<std::uint32_t> members, const Eigen::Vector3d& target) {
    return try_merge({members.begin(), members.size()}, target);
  }
  template <std::size_t N>
  Verdict merge(const std::array<std::uint32_t, N>& members, const Eigen::Vector3d& target) {
    return try_merge({members.data(), N}, target);
  }
  Verdict merge(const std::vector<std::uint32_t>& members, const Eigen::Vector3d& target) {
    return try_merge({members.data(), members.size()}, target);
  }

  void count_refusal(Verdict verdict) {
    if (verdict == Verdict::refused_by_link) ++plan_.record.refused_by_link;
    if (verdict == Verdict::refused_by_flip_guard) ++plan_.record.refused_by_flip_guard;
  }
  void count_fallback() { ++plan_.record.fell_back; }

  CollapsePlan take() { return std::move(plan_); }

 private:
  /// The vertices of a cluster, the survivor first.
  struct Members {
    const std::uint32_t* first;
    std::size_t count;
    std::size_t size() const { return count; }
    std::uint32_t operator[](std::size_t i) const { return first[i]; }
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return first + count; }
  };

  Verdict try_merge(Members members, const Eigen::Vector3d& target);

  /// Takes the collapses from one of the plan on back out of it.
  void take_back(std::size_t first);

  /// Whether the faces around all members that are no hubs keep to the guard. Notes the hubs that would move.
  bool keeps_orientation(Members members, const Eigen::Vector3d& target);
  /// Whether the faces that were at `v` in the input keep to the guard when its survivor lies at `target`.
  /// The vertices that are about to merge carry the mark `merging`.
  bool keeps_orientation_around(std::uint32_t v, const Eigen::Vector3d& target, std::uint32_t merging) const;
  /// The same of a vertex of very many faces, which each of its neighbours may want to move: begins where it was
  /// refused the last time. \param merged  what the members have become
  bool keeps_orientation_around_hub(std::uint32_t v, const Eigen::Vector3d& target, std::uint32_t merged);

  /// Whether a face that has turned keeps to the guard.
  bool keeps_to_guard(const Eigen::Vector3d& before, const Eigen::Vector3d& after) const {
    const double limit = guard_.min_cos * std::abs(guard_.min_cos);
    const double squares = before.squaredNorm(), cosine = before.dot(after);
    return !(squares > 0) || cosine * std::abs(cosine) > limit * squares * after.squaredNorm();
  }

  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::size_t kMany = 64;  // faces, of which a vertex with more is a hub

  const SurfaceT<Real>& surface_;
  FlipGuard guard_;
  detail::ClustersT<Real> clusters_;
  detail::LinkConditionT<Real> links_;
  std::vector<std::uint32_t> hubs_;                        // among the members, of those that move
  std::unordered_map<std::uint32_t, std::size_t> turned_;  // of a hub, the face that last turned too far
  CollapsePlan plan_;
};

template <typename Real>
auto PlanDraftT<Real>::try_merge(Members members, const Eigen::Vector3d& target) -> Verdict {
  const Eigen::Vector3d rounded = target.template cast<Real>().template cast<double>();
  if (!keeps_orientation(members, rounded)) return Verdict::refused_by_flip_guard;
  const std::uint32_t to = members[0];
  const std::size_t first = plan_.collapses.size();
  links_.begin();
  for (std::size_t i = 1; i < members.size(); ++i) {
    const std::uint32_t faces = links_.legal_faces(members[i], to);
    if (faces == 0) {
      take_back(first);
      return Verdict::refused_by_link;
    }
    clusters_.join(members[i], to);
    links_.grown(to);
    const auto rest = static_cast<std::uint32_t>(members.size() - 1 - i);
    plan_.collapses.push_back({members[i], to, faces, rest, target});
  }
  // Hubs last, as most of what their neighbours propose is refused without them.
  for (const std::uint32_t hub : hubs_)
    if (!keeps_orientation_around_hub(hub, rounded, to)) {
      take_back(first);
      return Verdict::refused_by_flip_guard;
    }
  clusters_.move(to, target.template cast<Real>());
  ++plan_.record.planned;
  return Verdict::accepted;
}

template <typename Real>
void PlanDraftT<Real>::take_back(std::size_t first) {
  for (; plan_.collapses.size() > first; plan_.collapses.pop_back())
    clusters_.part(plan_.collapses.back().from, plan_.collapses.back().to);
  links_.taken_back();
}

template <typename Real>
bool PlanDraftT<Real>::keeps_orientation(Members members, const Eigen::Vector3d& target) {
  hubs_.clear();
  if (guard_.min_cos <= -1) return true;
  const std::uint32_t member = clusters_.new_stamp();
  for (const std::uint32_t m : members) clusters_.mark(m) = member;
  bool keeps = true;
  for (const std::uint32_t m : members) {
    if (position(m) == target) continue;  // its faces stay as they are
    clusters_.for_each_member(m, [&](std::uint32_t v) {
      if (surface_.ring(v).n_faces() > kMany)
        hubs_.push_back(v);
      else
        keeps = keeps && keeps_orientation_around(v, target, member);
    });
    if (!keeps) return false;
  }
  return true;
}

template <typename Real>
bool PlanDraftT<Real>::keeps_orientation_around(std::uint32_t v, const Eigen::Vector3d& target,
                                                std::uint32_t merging) const {
  const Ring ring = surface_.ring(v);
  if (ring.size() == 0) return true;
  const bool given = surface_.has_reference_normals();
  const Eigen::Vector3d center = surface_.point(v);
  Eigen::Vector3d last_old, last_new;
  last_old.setZero();
  last_new.setZero();
  std::uint32_t last = kNone;  // none, or about to merge: its faces vanish
  for (std::size_t i = 0; i <= ring.n_faces(); ++i) {
    const std::uint32_t w = survivor(ring[i]);
    const Eigen::Vector3d spoke_old = surface_.point(ring[i]) - center, spoke_new = position(w) - target;
    const bool merges = clusters_.mark(w) == merging;
    if (!merges && last != kNone && last != w) {
      const Eigen::Vector3d before = given ? surface_.reference_normal(v, i - 1) : last_old.cross(spoke_old);
      const Eigen::Vector3d after = last_new.cross(spoke_new);
      if (!keeps_to_guard(before, after)) return false;
    }
    last = merges ? kNone : w;
    last_old = spoke_old;
    last_new = spoke_new;
  }
  return true;
}

template <typename Real>
bool PlanDraftT<Real>::keeps_orientation_around_hub(std::uint32_t v, const Eigen::Vector3d& target,
                                                    std::uint32_t merged) {
  const Ring ring = surface_.ring(v);
  const bool given = surface_.has_reference_normals();
  const Eigen::Vector3d center = surface_.point(v);
  std::size_t& first = turned_[v];
  for (std::size_t n = 0, i = first; n < ring.n_faces(); ++n, i = i + 1 < ring.n_faces() ? i + 1 : 0) {
    const std::uint32_t a = survivor(ring[i]), b = survivor(ring[i + 1]);
    if (a == b || a == merged || b == merged) continue;
    const Eigen::Vector3d before =
        given ? surface_.reference_normal(v, i)
              : (surface_.point(ring[i]) - center).cross(surface_.point(ring[i + 1]) - center);
    if (keeps_to_guard(before, (position(a) - target).cross(position(b) - target))) continue;
    first = i;
    return false;
  }
  return true;
}

}  // namespace whittle
