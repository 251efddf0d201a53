/// \file
/// Whether two clusters may become one without breaking the manifold.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "whittle/plan/ClustersT.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::detail {

/// The link condition: the only common neighbours of the two ends are the vertices opposite the edge.
///
///         l            An interior edge has two faces and the common neighbours l and r, a boundary edge
///        / \           one. A further common neighbour x means that the edge, x-from and x-to bound no face:
///   from --- to        the collapse would glue the surface together along a line.
///        \ /
///         r
///
/// A vertex of very many faces, a hub, is asked about by each of its neighbours. So that this takes no time in the
/// square of their number, what is asked there is answered from the other end.
template <typename Real>
class LinkConditionT {
 public:
  /// \param clusters  must outlive this
  explicit LinkConditionT(ClustersT<Real>& clusters) : clusters_(clusters), surface_(clusters.surface()) {}

  /// How many faces the collapse would remove; 0 where it is illegal.
  std::uint32_t legal_faces(std::uint32_t from, std::uint32_t to);

  /// To be told of what changes: that a cluster has grown, or that all joins since the beginning of a trial have been
  /// taken back.
  void begin() {
    n_joins_before_ = n_joins_;
    learnt_.clear();
    has_grown_ = false;
  }
  void grown(std::uint32_t survivor) {
    n_joins_ += is_hub(survivor);
    has_grown_ = true;
  }
  void taken_back() {
    n_joins_ = n_joins_before_;
    for (const std::uint64_t pair : learnt_) neighbours_.erase(pair);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::size_t kMany = 64;  // neighbours, of which a cluster with more is a hub

  /// The faces that have both ends, and how many neighbours these have.
  struct Link {
    std::uint32_t shared_faces = 0, common = 0, valence_from = 0, valence_to = 0;
  };

  bool is_hub(std::uint32_t survivor) const;
  /// Which of two clusters has fewer neighbours, in a time that depends on it only.
  std::uint32_t smaller(std::uint32_t a, std::uint32_t b) const;
  bool are_neighbours(std::uint32_t a, std::uint32_t b);
  bool has_neighbour(std::uint32_t cluster, std::uint32_t wanted) const;
  std::uint32_t valence_up_to(std::uint32_t survivor, std::uint32_t most);

  /// Goes around the vertices of a cluster: calls `visit` with each neighbour once.
  /// \return the faces at the other cluster
  template <typename Visit>
  std::uint32_t walk(std::uint32_t from, std::uint32_t to, std::uint32_t stamp, Visit visit);
  Link link(std::uint32_t from, std::uint32_t to);
  Link link_at_hub(std::uint32_t from, std::uint32_t to);

  ClustersT<Real>& clusters_;
  const SurfaceT<Real>& surface_;
  std::vector<std::uint32_t> ring_;  // working memory
  std::array<std::uint32_t, 2> opposite_{};
  // Of two hubs: 0 if they are neighbours, else after how many joins they were not.
  std::unordered_map<std::uint64_t, std::size_t> neighbours_;
  std::size_t n_joins_ = 1, n_joins_before_ = 1;
  bool has_grown_ = false;  // in this trial
  std::vector<std::uint64_t>
      learnt_;  // pairs of which an answer is known that joins of this trial may have changed
};

template <typename Real>
std::uint32_t LinkConditionT<Real>::legal_faces(std::uint32_t from, std::uint32_t to) {
  if (surface_.is_complex(from) || surface_.is_complex(to)) return 0;
  const bool from_boundary = surface_.is_boundary(from), to_boundary = surface_.is_boundary(to);
  if (from_boundary && !to_boundary) return 0;
  const Link found = is_hub(from) || is_hub(to) ? link_at_hub(from, to) : link(from, to);
  if (found.shared_faces == 2) {
    const bool pinches = from_boundary && to_boundary;  // the boundary would touch itself
    const bool tetrahedron =
        found.valence_from == 3 && found.valence_to == 3 && !to_boundary;  // two faces back to back
    return found.common == 2 && !pinches && !tetrahedron ? 2 : 0;
  }
  const bool lone_triangle = found.valence_from == 2 && found.valence_to == 2;
  return found.shared_faces == 1 && found.common == 1 && !lone_triangle ? 1 : 0;
}

template <typename Real>
template <typename Visit>
std::uint32_t LinkConditionT<Real>::walk(std::uint32_t from, std::uint32_t to, std::uint32_t stamp,
                                         Visit visit) {
  std::uint32_t shared_faces = 0;
  clusters_.for_each_member(from, [&](std::uint32_t member) {
    const Ring ring = surface_.ring(member);
    if (ring.size() == 0) return;
    std::uint32_t last = kNone;
    for (std::size_t i = 0; i <= ring.n_faces(); ++i) {
      const std::uint32_t v = clusters_.survivor(ring[i]);
      if (v != from && last != kNone && last != from && v != last && (v == to || last == to))
        opposite_[shared_faces++ & 1] = v == to ? last : v;
      last = v;
      if (v == from || clusters_.mark(v) == stamp) continue;
      clusters_.mark(v) = stamp;
      visit(v);
    }
  });
  return shared_faces;
}

template <typename Real>
auto LinkConditionT<Real>::link(std::uint32_t from, std::uint32_t to) -> Link {
  const std::uint32_t near_from = clusters_.new_stamp(), near_both = clusters_.new_stamp(),
                      near_to = clusters_.new_stamp();
  Link out;
  out.shared_faces = walk(from, to, near_from, [&](std::uint32_t) { ++out.valence_from; });
  clusters_.for_each_member(to, [&](std::uint32_t member) {
    for (const std::uint32_t w : surface_.ring(member)) {
      const std::uint32_t v = clusters_.survivor(w);
      std::uint32_t& mark = clusters_.mark(v);
      if (v == to || mark == near_both || mark == near_to) continue;
      const bool both = mark == near_from;
      mark = both ? near_both : near_to;
      out.common += both;
      ++out.valence_to;
    }
  });
  return out;
}

/// Goes around the smaller cluster only. Valences beyond 3 and more than 3 common neighbours make no difference.
template <typename Real>
auto LinkConditionT<Real>::link_at_hub(std::uint32_t from, std::uint32_t to) -> Link {
  const std::uint32_t near = smaller(from, to), far = near == from ? to : from;
  ring_.clear();
  Link out;
  out.shared_faces = walk(near, far, clusters_.new_stamp(), [&](std::uint32_t v) { ring_.push_back(v); });
  if (out.shared_faces != 1 && out.shared_faces != 2) return out;
  const std::uint32_t l = opposite_[0], r = out.shared_faces == 2 ? opposite_[1] : l;
  out.common = l == r ? 1 : 2;
  for (const std::uint32_t v : ring_)
    if (v != far && v != l && v != r && are_neighbours(v, far)) {
      out.common = 3;
      break;
    }
  out.valence_from = static_cast<std::uint32_t>(ring_.size());
  out.valence_to = valence_up_to(far, 4);
  if (near == to) std::swap(out.valence_from, out.valence_to);
  return out;
}

template <typename Real>
bool LinkConditionT<Real>::is_hub(std::uint32_t survivor) const {
  std::size_t n = surface_.ring(survivor).size();
  for (std::uint32_t v = clusters_.next(survivor); v != survivor && n <= kMany; v = clusters_.next(v))
    n += surface_.ring(v).size();
  return n > kMany;
}

template <typename Real>
std::uint32_t LinkConditionT<Real>::smaller(std::uint32_t a, std::uint32_t b) const {
  std::size_t around_a = 0, around_b = 0;
  bool is_a_done = false, is_b_done = false;
  for (std::uint32_t v = a, w = b;;) {
    if (is_b_done || (!is_a_done && around_a <= around_b)) {
      around_a += surface_.ring(v).size();
      is_a_done = (v = clusters_.next(v)) == a;
    } else {
      around_b += surface_.ring(w).size();
      is_b_done = (w = clusters_.next(w)) == b;
    }
    if (is_a_done && around_a <= around_b) return a;
    if (is_b_done && around_b < around_a) return b;
  }
}

template <typename Real>
bool LinkConditionT<Real>::has_neighbour(std::uint32_t cluster, std::uint32_t wanted) const {
  std::uint32_t member = cluster;
  do
    for (const std::uint32_t w : surface_.ring(member))
      if (clusters_.survivor(w) == wanted) return true;
  while ((member = clusters_.next(member)) != cluster);
  return false;
}

template <typename Real>
bool LinkConditionT<Real>::are_neighbours(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t near = smaller(a, b), far = near == a ? b : a;
  if (!is_hub(near)) return has_neighbour(near, far);
  // Neighbours remain neighbours as clusters grow.
  const std::uint64_t pair = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  const auto [known, is_new] = neighbours_.emplace(pair, 0);
  if (!is_new && (known->second == 0 || known->second == n_joins_)) return known->second == 0;
  const bool found = has_neighbour(near, far);
  known->second = found ? 0 : n_joins_;
  if (has_grown_) learnt_.push_back(pair);
  return found;
}

template <typename Real>
std::uint32_t LinkConditionT<Real>::valence_up_to(std::uint32_t survivor, std::uint32_t most) {
  const std::uint32_t stamp = clusters_.new_stamp();
  std::uint32_t valence = 0, member = survivor;
  do
    for (const std::uint32_t w : surface_.ring(member)) {
      const std::uint32_t v = clusters_.survivor(w);
      if (v == survivor || clusters_.mark(v) == stamp) continue;
      clusters_.mark(v) = stamp;
      if (++valence == most) return valence;
    }
  while ((member = clusters_.next(member)) != survivor);
  return valence;
}

}  // namespace whittle::detail
