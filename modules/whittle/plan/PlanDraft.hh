/// \file
/// A plan while it is drawn up, and the surface as it will be once the plan so far is executed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/FlipGuard.hh"
#include "whittle/surface/Surface.hh"

namespace whittle {

/// Adds clusters to a plan one after the other. Every cluster is tested on the surface as the earlier ones
/// leave it: for the link condition, so that executors find every planned collapse legal, and for the flip
/// guard.
template <typename Real>
class PlanDraftT {
 public:
  using Point = typename IndexedMeshT<Real>::Point;

  PlanDraftT(const SurfaceT<Real>& surface, FlipGuard guard) : surface_(surface), guard_(guard) {
    nodes_.reserve(surface.n_vertices());
    for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
      const Point& p = surface.mesh().points[v];
      nodes_.push_back({v, v, 0, p});
    }
    plan_.stages.push_back(0);
    plan_.collapses.reserve(2 * nodes_.size() / 3);  // as many as folds of triangles can make
  }

  /// What has become of a vertex; the vertex itself if it still stands.
  std::uint32_t survivor(std::uint32_t v) const { return nodes_[v].survivor; }

  /// Where a survivor lies.
  Eigen::Vector3d position(std::uint32_t survivor) const {
    return nodes_[survivor].position.template cast<double>();
  }

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

  /// All that is asked of a vertex at once, so that a visit costs one cache line.
  struct Node {
    std::uint32_t survivor, next;  ///< what it has become; the next of its cluster, which is a circular list
    std::uint32_t mark;
    Point position;  ///< of a survivor, rounded as the mesh will hold it
  };

  /// Calls `visit(v)` for the vertices that have become `survivor`, itself included.
  template <typename Visit>
  void for_each_member(std::uint32_t survivor, Visit visit) const {
    std::uint32_t v = survivor;
    do visit(v);
    while ((v = nodes_[v].next) != survivor);
  }

  /// How many faces the collapse would remove; 0 where it is illegal.
  std::uint32_t legal_faces(std::uint32_t from, std::uint32_t to);

  Verdict try_merge(Members members, const Eigen::Vector3d& target);

  bool keeps_orientation(Members members, const Eigen::Vector3d& target);

  /// Whether the faces that were at `v` in the input keep to the guard when its survivor lies at `target`.
  /// The vertices that are about to merge carry the mark `merging`.
  bool keeps_orientation_around(std::uint32_t v, const Eigen::Vector3d& target, std::uint32_t merging) const;

  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// A stamp that no mark has.
  std::uint32_t new_stamp() {
    if (stamp_ == 0xffffffffu) {
      for (Node& node : nodes_) node.mark = 0;
      stamp_ = 0;
    }
    return ++stamp_;
  }

  /// Moves the cluster of `from` over to `to`. Exchanging the links of one vertex of each list joins them,
  /// and exchanging them again parts them.
  void join(std::uint32_t from, std::uint32_t to) {
    relabel(from, to);
    std::swap(nodes_[from].next, nodes_[to].next);
  }
  void part(std::uint32_t from, std::uint32_t to) {
    std::swap(nodes_[from].next, nodes_[to].next);
    relabel(from, from);
  }
  void relabel(std::uint32_t member, std::uint32_t survivor) {
    std::uint32_t v = member;
    do nodes_[v].survivor = survivor;
    while ((v = nodes_[v].next) != member);
  }

  const SurfaceT<Real>& surface_;
  FlipGuard guard_;
  std::vector<Node> nodes_;
  std::uint32_t stamp_ = 0;
  CollapsePlan plan_;
};

template <typename Real>
auto PlanDraftT<Real>::try_merge(Members members, const Eigen::Vector3d& target) -> Verdict {
  if (!keeps_orientation(members, target)) return Verdict::refused_by_flip_guard;
  const std::uint32_t to = members[0];
  const std::size_t first = plan_.collapses.size();
  for (std::size_t i = 1; i < members.size(); ++i) {
    const std::uint32_t faces = legal_faces(members[i], to);
    if (faces > 0) {
      join(members[i], to);
      const auto rest = static_cast<std::uint32_t>(members.size() - 1 - i);
      plan_.collapses.push_back({members[i], to, faces, rest, target});
      continue;
    }
    for (; plan_.collapses.size() > first; plan_.collapses.pop_back()) part(plan_.collapses.back().from, to);
    return Verdict::refused_by_link;
  }
  nodes_[to].position = target.template cast<Real>();
  ++plan_.record.planned;
  return Verdict::accepted;
}

/// The link condition: the only common neighbours of the two ends are the vertices opposite the edge.
///
///         l            An interior edge has two faces and the common neighbours l and r, a boundary edge
///        / \           one. A further common neighbour x means that the edge, x-from and x-to bound no face:
///   from --- to        the collapse would glue the surface together along a line.
///        \ /
///         r
template <typename Real>
std::uint32_t PlanDraftT<Real>::legal_faces(std::uint32_t from, std::uint32_t to) {
  if (surface_.is_complex(from) || surface_.is_complex(to)) return 0;
  const bool from_boundary = surface_.is_boundary(from), to_boundary = surface_.is_boundary(to);
  if (from_boundary && !to_boundary) return 0;

  const std::uint32_t near_from = new_stamp(), near_both = new_stamp(), near_to = new_stamp();
  std::uint32_t shared_faces = 0, common = 0, valence_from = 0, valence_to = 0;
  for_each_member(from, [&](std::uint32_t member) {
    const Ring ring = surface_.ring(member);
    if (ring.size() == 0) return;
    std::uint32_t last = kNone;
    for (std::size_t i = 0; i <= ring.n_faces(); ++i) {
      const std::uint32_t v = survivor(ring[i]);
      if (v != from && last != kNone && last != from && v != last) shared_faces += v == to || last == to;
      last = v;
      if (v == from || nodes_[v].mark == near_from) continue;
      nodes_[v].mark = near_from;
      ++valence_from;
    }
  });
  for_each_member(to, [&](std::uint32_t member) {
    for (const std::uint32_t w : surface_.ring(member)) {
      const std::uint32_t v = survivor(w);
      if (v == to || nodes_[v].mark == near_both || nodes_[v].mark == near_to) continue;
      const bool both = nodes_[v].mark == near_from;
      nodes_[v].mark = both ? near_both : near_to;
      common += both;
      ++valence_to;
    }
  });
  if (shared_faces == 2) {
    const bool pinches = from_boundary && to_boundary;  // the boundary would touch itself
    const bool tetrahedron = valence_from == 3 && valence_to == 3 && !to_boundary;  // two faces back to back
    return common == 2 && !pinches && !tetrahedron ? 2 : 0;
  }
  const bool lone_triangle = valence_from == 2 && valence_to == 2;
  return shared_faces == 1 && common == 1 && !lone_triangle ? 1 : 0;
}

template <typename Real>
bool PlanDraftT<Real>::keeps_orientation(Members members, const Eigen::Vector3d& target) {
  if (guard_.min_cos <= -1) return true;
  const Eigen::Vector3d rounded = target.template cast<Real>().template cast<double>();
  const std::uint32_t member = new_stamp();
  for (const std::uint32_t m : members) nodes_[m].mark = member;
  bool keeps = true;
  for (const std::uint32_t m : members) {
    if (position(m) == rounded) continue;  // its faces stay as they are
    for_each_member(m,
                    [&](std::uint32_t v) { keeps = keeps && keeps_orientation_around(v, rounded, member); });
    if (!keeps) break;
  }
  return keeps;
}

template <typename Real>
bool PlanDraftT<Real>::keeps_orientation_around(std::uint32_t v, const Eigen::Vector3d& target,
                                                std::uint32_t merging) const {
  const Ring ring = surface_.ring(v);
  if (ring.size() == 0) return true;
  const bool given = surface_.has_reference_normals();
  const Eigen::Vector3d center = surface_.point(v);
  const double limit = guard_.min_cos * std::abs(guard_.min_cos);
  Eigen::Vector3d last_old, last_new;
  last_old.setZero();
  last_new.setZero();
  std::uint32_t last = kNone;  // none, or about to merge: its faces vanish
  for (std::size_t i = 0; i <= ring.n_faces(); ++i) {
    const std::uint32_t w = survivor(ring[i]);
    const Eigen::Vector3d spoke_old = surface_.point(ring[i]) - center, spoke_new = position(w) - target;
    const bool merges = nodes_[w].mark == merging;
    if (!merges && last != kNone && last != w) {
      const Eigen::Vector3d before = given ? surface_.reference_normal(v, i - 1) : last_old.cross(spoke_old);
      const Eigen::Vector3d after = last_new.cross(spoke_new);
      const double squares = before.squaredNorm(), cosine = before.dot(after);
      if (squares > 0 && !(cosine * std::abs(cosine) > limit * squares * after.squaredNorm())) return false;
    }
    last = merges ? kNone : w;
    last_old = spoke_old;
    last_new = spoke_new;
  }
  return true;
}

}  // namespace whittle
