/// \file
/// A plan while it is drawn up, and the surface as it will be once the plan so far is executed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "whittle/CollapsePlan.hh"
#include "whittle/Surface.hh"

namespace whittle {

/// The flip guard. A cluster is refused if a surviving face would lie at more than about 78 degrees to its
/// *original* normal. Judged against the current normal instead, flips come back in chains of small turns.
struct FlipGuard {
  double min_cos = 0.2;  ///< least cosine between new and original normal, in [-1, 1); -1 turns the guard off

  /// \throw InvalidParameter
  void validate() const {
    if (!(min_cos >= -1 && min_cos < 1)) throw InvalidParameter("the flip guard's cosine must be in [-1, 1)");
  }
};

/// Adds clusters to a plan one after the other. Every cluster is tested on the surface as the earlier ones
/// leave it: for the link condition, so that executors find every planned collapse legal, and for the flip
/// guard.
template <typename Real>
class PlanDraftT {
 public:
  using Point = typename IndexedMeshT<Real>::Point;

  PlanDraftT(const SurfaceT<Real>& surface, FlipGuard guard)
      : surface_(surface),
        guard_(guard),
        survivor_(surface.n_vertices()),
        next_(surface.n_vertices()),
        mark_(surface.n_vertices(), 0) {
    std::iota(survivor_.begin(), survivor_.end(), 0u);
    next_ = survivor_;
    position_.reserve(surface.n_vertices());
    for (std::uint32_t v = 0; v < surface.n_vertices(); ++v)
      position_.push_back(surface.point(v).template cast<Real>());
    plan_.stages.push_back(0);
  }

  /// What has become of a vertex; the vertex itself if it still stands.
  std::uint32_t survivor(std::uint32_t v) const { return survivor_[v]; }

  /// Where a survivor lies.
  Eigen::Vector3d position(std::uint32_t survivor) const {
    return position_[survivor].template cast<double>();
  }

  enum class Verdict { accepted, refused_by_link, refused_by_flip_guard };

  /// Merges `members` into the first of them, at `target`; all must be survivors and connected by edges to
  /// the first. Refused, nothing changes. The caller counts the refusal with `count_refusal`, for it may have
  /// another proposal for the same place.
  Verdict merge(const std::vector<std::uint32_t>& members, const Eigen::Vector3d& target);

  void count_refusal(Verdict verdict) {
    if (verdict == Verdict::refused_by_link) ++plan_.record.refused_by_link;
    if (verdict == Verdict::refused_by_flip_guard) ++plan_.record.refused_by_flip_guard;
  }
  void count_fallback() { ++plan_.record.fell_back; }

  CollapsePlan take() { return std::move(plan_); }

 private:
  /// Calls `visit(face, corners)` for the faces around a survivor that have not vanished, with the survivors
  /// of their corners.
  template <typename Visit>
  void for_each_face(std::uint32_t survivor, Visit visit) const {
    std::uint32_t v = survivor;
    do {
      const auto [begin, end] = surface_.star(v);
      for (const std::uint32_t* f = begin; f != end; ++f) {
        const auto& t = surface_.triangle(*f);
        const std::array<std::uint32_t, 3> c{survivor_[t[0]], survivor_[t[1]], survivor_[t[2]]};
        if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) visit(*f, c);
      }
      v = next_[v];
    } while (v != survivor);
  }

  /// How many faces the collapse would remove; 0 where it is illegal.
  std::uint32_t legal_faces(std::uint32_t from, std::uint32_t to);

  bool keeps_orientation(const std::vector<std::uint32_t>& members, const Eigen::Vector3d& target);

  /// A stamp that no entry of `mark_` has.
  std::uint32_t new_stamp() {
    if (stamp_ == 0xffffffffu) {
      std::fill(mark_.begin(), mark_.end(), 0u);
      stamp_ = 0;
    }
    return ++stamp_;
  }

  /// How much each member counts for the attributes at the target; they sum to 1.
  std::vector<double> weights(const std::vector<std::uint32_t>& members, const Eigen::Vector3d& target) const;

  /// Moves the cluster of `from` over to `to`. The clusters are circular lists, so exchanging the links of
  /// one vertex of each joins them, and exchanging them again parts them.
  void join(std::uint32_t from, std::uint32_t to) {
    relabel(from, to);
    std::swap(next_[from], next_[to]);
  }
  void part(std::uint32_t from, std::uint32_t to) {
    std::swap(next_[from], next_[to]);
    relabel(from, from);
  }
  void relabel(std::uint32_t member, std::uint32_t survivor) {
    std::uint32_t v = member;
    do survivor_[v] = survivor;
    while ((v = next_[v]) != member);
  }

  const SurfaceT<Real>& surface_;
  FlipGuard guard_;
  std::vector<std::uint32_t> survivor_, next_;
  std::vector<Point> position_;  // of survivors, rounded as the mesh will hold it
  std::vector<std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
  CollapsePlan plan_;
};

template <typename Real>
auto PlanDraftT<Real>::merge(const std::vector<std::uint32_t>& members, const Eigen::Vector3d& target)
    -> Verdict {
  if (!keeps_orientation(members, target)) return Verdict::refused_by_flip_guard;
  const std::uint32_t to = members[0];
  const std::size_t first = plan_.collapses.size();
  for (std::size_t i = 1; i < members.size(); ++i) {
    const std::uint32_t faces = legal_faces(members[i], to);
    if (faces > 0) {
      join(members[i], to);
      plan_.collapses.push_back({members[i], to, faces, 0, target});
      continue;
    }
    for (; plan_.collapses.size() > first; plan_.collapses.pop_back()) part(plan_.collapses.back().from, to);
    return Verdict::refused_by_link;
  }
  const std::vector<double> weight = weights(members, target);
  double sum = weight[0];
  for (std::size_t i = 1; i < members.size(); ++i) {
    sum += weight[i];
    plan_.collapses[first + i - 1].share = sum > 0 ? static_cast<float>(weight[i] / sum) : 0.5f;
  }
  position_[to] = target.template cast<Real>();
  ++plan_.record.planned;
  return Verdict::accepted;
}

/// Two members: by the target's place between them. Three: its barycentric coordinates. More: all alike.
template <typename Real>
std::vector<double> PlanDraftT<Real>::weights(const std::vector<std::uint32_t>& members,
                                              const Eigen::Vector3d& target) const {
  const auto at = [&](std::size_t i) { return position(members[i]); };
  if (members.size() == 2) {
    const Eigen::Vector3d edge = at(1) - at(0);
    const double t = edge.squaredNorm() > 0 ? (target - at(0)).dot(edge) / edge.squaredNorm() : 0.5;
    return {1 - std::clamp(t, 0.0, 1.0), std::clamp(t, 0.0, 1.0)};
  }
  if (members.size() == 3) {
    const Eigen::Vector3d n = (at(1) - at(0)).cross(at(2) - at(0));
    std::vector<double> area;
    for (std::size_t i = 0; i < 3; ++i)
      area.push_back(std::max(0.0, n.dot((at((i + 1) % 3) - target).cross(at((i + 2) % 3) - target))));
    const double sum = area[0] + area[1] + area[2];
    if (sum > 0) return {area[0] / sum, area[1] / sum, area[2] / sum};
  }
  return std::vector<double>(members.size(), 1.0 / static_cast<double>(members.size()));
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
  for_each_face(from, [&](std::uint32_t, const std::array<std::uint32_t, 3>& c) {
    for (const std::uint32_t v : c) {
      if (v == to) ++shared_faces;
      if (v == from || mark_[v] == near_from) continue;
      mark_[v] = near_from;
      ++valence_from;
    }
  });
  for_each_face(to, [&](std::uint32_t, const std::array<std::uint32_t, 3>& c) {
    for (const std::uint32_t v : c) {
      if (v == to || mark_[v] == near_both || mark_[v] == near_to) continue;
      const bool both = mark_[v] == near_from;
      mark_[v] = both ? near_both : near_to;
      common += both;
      ++valence_to;
    }
  });
  const bool legal =
      shared_faces == 2
          ? common == 2 && !(from_boundary && to_boundary) && !(valence_from == 3 && valence_to == 3)
          : shared_faces == 1 && common == 1 && !(valence_from == 2 && valence_to == 2);
  return legal ? shared_faces : 0;
}

template <typename Real>
bool PlanDraftT<Real>::keeps_orientation(const std::vector<std::uint32_t>& members,
                                         const Eigen::Vector3d& target) {
  if (guard_.min_cos <= -1) return true;
  const Eigen::Vector3d rounded = target.template cast<Real>().template cast<double>();
  const std::uint32_t member = new_stamp();
  for (const std::uint32_t m : members) mark_[m] = member;
  bool keeps = true;
  for (const std::uint32_t m : members) {
    if (position(m) == rounded) continue;  // its faces stay as they are
    for_each_face(m, [&](std::uint32_t f, const std::array<std::uint32_t, 3>& c) {
      if (!keeps) return;
      int inside = 0;
      std::array<Eigen::Vector3d, 3> p;
      for (int i = 0; i < 3; ++i) {
        const bool moves = mark_[c[i]] == member;
        inside += moves;
        p[i] = moves ? rounded : position(c[i]);
      }
      if (inside > 1) return;  // the face vanishes
      const Eigen::Vector3d before = surface_.reference_normal(f), after = (p[1] - p[0]).cross(p[2] - p[0]);
      const double lengths = std::sqrt(before.squaredNorm() * after.squaredNorm());
      if (before.squaredNorm() > 0 && !(before.dot(after) > guard_.min_cos * lengths)) keeps = false;
    });
    if (!keeps) break;
  }
  return keeps;
}

}  // namespace whittle
