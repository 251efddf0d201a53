/// \file
/// How mq judges a collapse, and what it changes.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "whittle/CollapsePlan.hh"
#include "whittle/CornerTable.hh"
#include "whittle/MemorylessQuadricMesh.hh"
#include "whittle/PackedNormal.hh"
#include "whittle/SymmetricMatrix.hh"

namespace whittle {

/// Goes around `v`: shows its neighbours to `visit`, and collects the faces that stay when half-edge `c`
/// collapses to `target`.
template <typename Visit>
auto MemorylessQuadricMesh::survey(std::uint32_t v, Corner c, const Vec& target, Hand& hand, Visit visit)
    -> Verdict {
  const Corner d = table_.twin(c), first = table_.first(v);
  const float limit = min_cos_ * std::abs(min_cos_);
  if (!hand.has(table_.vertex(next(first)))) return Verdict::elsewhere;
  Corner at = first, last = first;
  do {
    const std::uint32_t after = table_.vertex(previous(at));  // the neighbour that comes next
    if (!hand.has(after)) return Verdict::elsewhere;
    visit(vertices_[table_.vertex(next(at))]);
    if (at >> 2 != c >> 2 && (d == kNoCorner || at >> 2 != d >> 2)) {
      const Vec &p = position(at), &q = position(next(at)), &r = vertices_[after].position;
      const Turn turn{at, (q - p).cross(r - p), (q - target).cross(r - target)};
      const float before = turn.before.squaredNorm(), now = turn.after.squaredNorm();
      const float cosine = turn.before.dot(turn.after);
      if (before > 0 && !(cosine * std::abs(cosine) > limit * before * now)) return Verdict::illegal;
      const PackedNormal input = table_.face(at).normal;
      const float overall = input.unpacked().dot(turn.after);
      if (!input.is_none() && !(overall > 0 && overall * overall > kUpright * now)) return Verdict::illegal;
      hand.turns.push_back(turn);
    }
    last = at;
    at = table_.around(at);
  } while (at != kNoCorner && at != first);
  if (at == kNoCorner) visit(vertices_[table_.vertex(previous(last))]);
  return Verdict::legal;
}

inline auto MemorylessQuadricMesh::judge(Corner c, const Placement& placement, Hand& hand) -> Verdict {
  const std::uint32_t a = table_.vertex(c), b = table_.vertex(next(c));
  const bool a_open = table_.is_open(a), b_open = table_.is_open(b), interior = table_.twin(c) != kNoCorner;
  if (interior && a_open && b_open) return Verdict::illegal;  // the boundary would touch itself
  if ((a_open && !b_open && holds_[b] != kFree) || (b_open && !a_open && holds_[a] != kFree))
    return Verdict::illegal;  // the boundary would leave its place

  const Vec target = position(c) + placement.offset;
  const std::uint32_t mark = hand.stamp += hand.stride;
  hand.turns.clear();
  std::size_t common = 0;
  const Verdict around_a = survey(a, c, target, hand, [&](Vertex& v) { v.mark = mark; });
  if (around_a != Verdict::legal) return around_a;
  const std::size_t of_a = hand.turns.size();
  const Verdict around_b = survey(b, c, target, hand, [&](const Vertex& v) { common += v.mark == mark; });
  if (around_b != Verdict::legal) return around_b;
  const std::size_t of_b = hand.turns.size() - of_a;
  const bool ear = (keeps_end(c) ? of_a : of_b) == 0;                                  // its tip would vanish
  const bool back_to_back = interior && !a_open && !b_open && of_a <= 1 && of_b <= 1;  // two faces would be
  return !ear && !back_to_back && common == (interior ? 2u : 1u) ? Verdict::legal : Verdict::illegal;
}

/// Calls `visit(half-edge, neighbour)` for the two boundary edges at `v`, if there are.
template <typename Visit>
void MemorylessQuadricMesh::for_each_boundary_edge(std::uint32_t v, Visit visit) const {
  if (!table_.is_open(v)) return;
  const Corner first = table_.first(v);
  visit(first, table_.vertex(next(first)));
  Corner last = first;
  for (Corner at = first; at != kNoCorner; at = table_.around(at)) last = at;
  visit(previous(last), table_.vertex(previous(last)));
}

/// The face of `c` is about to vanish and its two other edges are about to become one: sees to it that this
/// is queued once, if one of them is. \return a half-edge of it that has yet to be queued, or kNoCorner.
inline Corner MemorylessQuadricMesh::fuse(Corner c) {
  const auto queued = [&](Corner at) {
    return at != kNoCorner && (table_.face(at).queued >> (at & 3) & 1) != 0;
  };
  const Corner left = table_.twin(next(c)), right = table_.twin(previous(c));
  if (queued(left) && queued(right))
    table_.face(right).queued &= static_cast<std::uint16_t>(~(1u << (right & 3)));
  if (queued(left) || queued(right) || !(queued(next(c)) || queued(previous(c)))) return kNoCorner;
  return left != kNoCorner ? left : right;
}

/// Takes out of the ring's quadrics what vanishes or changes with the collapse of `c`, and puts in what the
/// faces that stay become. \param own  gains the survivor's faces
inline void MemorylessQuadricMesh::update_ring(Corner c, const Hand& hand, SymmetricMatrix& own) {
  for (const Corner side : {c, table_.twin(c)}) {
    if (side == kNoCorner) continue;
    const Corner tip = previous(side);
    quadrics_[table_.vertex(tip)] -= face_quadric(edge(side).cross(-edge(tip)));
  }
  for (const std::uint32_t v : {table_.vertex(c), table_.vertex(next(c))})
    for_each_boundary_edge(
        v, [&](Corner half, std::uint32_t w) { quadrics_[w] -= boundary_quadric(edge(half)); });
  for (const Turn& turn : hand.turns) {
    const SymmetricMatrix after = face_quadric(turn.after);
    own += after;
    const SymmetricMatrix change = after - face_quadric(turn.before);
    quadrics_[table_.vertex(next(turn.corner))] += change;
    quadrics_[table_.vertex(previous(turn.corner))] += change;
  }
}

inline Collapse MemorylessQuadricMesh::collapse(Corner c, const Placement& placement, const Hand& hand,
                                                std::array<Corner, 2>& unqueued) {
  const std::uint32_t to = table_.vertex(c), from = table_.vertex(next(c));
  const Vec e = edge(c), target = position(c) + placement.offset;
  const Corner d = table_.twin(c);
  SymmetricMatrix quadric;
  update_ring(c, hand, quadric);

  const bool swap = keeps_end(c);
  if (swap) std::swap(input_[from], input_[to]);  // the table merges the end into the start
  const float along = e.squaredNorm() > 0 ? placement.offset.dot(e) / e.squaredNorm() : 0.5f;
  unqueued = {fuse(c), d == kNoCorner ? kNoCorner : fuse(d)};
  table_.collapse(c);
  vertices_[to].position = target;
  if (holds_[from] == kFixed) holds_[to] = kFixed;
  if (!weights_.empty()) weights_[to] = std::max(weights_[to], weights_[from]);
  for_each_boundary_edge(to, [&](Corner half, std::uint32_t w) {
    const SymmetricMatrix boundary = boundary_quadric(edge(half));
    quadrics_[w] += boundary;
    quadric += boundary;
  });
  quadrics_[to] = quadric;
  if (hand.part == kEverywhere) {
    Corner at = table_.first(to);
    do {
      set_part(at);
      at = table_.around(at);
    } while (at != kNoCorner && at != table_.first(to));
  }
  return {input_[from], input_[to], d == kNoCorner ? 1u : 2u,
          std::clamp(swap ? 1 - along : along, 0.0f, 1.0f), center_ + scale_ * target.cast<double>()};
}

}  // namespace whittle
