/// \file
/// How mq places and judges a collapse, and what it changes.
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

/// Minimises the sum of the squared distances to both ends' planes, u Ha u + (u - e) Hb (u - e), with a
/// slight pull to the middle that decides where the planes leave a direction open.
inline auto MemorylessQuadricMesh::best_place(Corner c) const -> Placement {
  const std::uint32_t a = table_.vertex(c), b = table_.vertex(next(c));
  SymmetricMatrix at_a = quadrics_[a], at_b = quadrics_[b];
  const Vec e = vertices_[b].position - vertices_[a].position;
  if (!values_.empty()) {
    at_a += values_.along(a, b, e, a);
    at_b += values_.along(a, b, e, b);
  }
  const Vec pull_b = at_b * e;
  if (holds_[a] == kFixed) return {Vec::Zero(), std::max(0.0f, e.dot(pull_b))};
  if (holds_[b] == kFixed) return {e, std::max(0.0f, e.dot(at_a * e))};
  const SymmetricMatrix sum = at_a + at_b;
  const float pull = 1e-5f * sum.trace();
  const Vec middle = e / 2;
  const Vec u = (sum + SymmetricMatrix::identity(pull)).solve(pull_b + pull * middle);
  if ((u - middle).squaredNorm() <= 4 * e.squaredNorm())
    return {u, std::max(0.0f, (e - u).dot(pull_b) - pull * u.dot(u - middle))};
  return {middle, std::max(0.0f, middle.dot(sum * middle))};
}

inline auto MemorylessQuadricMesh::place(Corner c) const -> Placement {
  Placement placement = best_place(c);
  if (!weights_.empty())
    placement.cost *= std::max(weights_[table_.vertex(c)], weights_[table_.vertex(next(c))]);
  return placement;
}

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
  const bool legal = !ear && !back_to_back && common == (interior ? 2u : 1u);
  return legal && (bound_.empty() || keeps_bound(c, target, hand)) ? Verdict::legal : Verdict::illegal;
}

/// Whether the points of the faces around the edge, those of `hand.turns` and those that vanish, stay near.
inline bool MemorylessQuadricMesh::keeps_bound(Corner c, const Vec& target, Hand& hand) const {
  auto& sorting = hand.sorting;
  sorting.clear();
  for (const Corner side : {c, table_.twin(c)})
    if (side != kNoCorner) sorting.faces.push_back(side >> 2);
  for (const Turn& turn : hand.turns) {
    const std::uint32_t face = turn.corner >> 2;
    sorting.faces.push_back(face);
    sorting.triangles.push_back({face, target, position(next(turn.corner)), position(previous(turn.corner))});
  }
  return bound_.sort(sorting);
}

/// Calls `visit(half-edge, neighbour)` for the boundary and feature edges at `v`.
template <typename Visit>
void MemorylessQuadricMesh::for_each_line(std::uint32_t v, Visit visit) const {
  if (!has_features_ && !table_.is_open(v)) return;
  const Corner first = table_.first(v);
  Corner at = first, last = first;
  do {
    if (table_.twin(at) == kNoCorner || table_.is_line(at)) visit(at, table_.vertex(next(at)));
    last = at;
    at = table_.around(at);
  } while (at != kNoCorner && at != first);
  if (at == kNoCorner) visit(previous(last), table_.vertex(previous(last)));
}

/// The face of `c` is about to vanish and its two other edges are about to become one: sees to it that this
/// is queued once, if one of them is. \return a half-edge of it that has yet to be queued, or kNoCorner.
inline Corner MemorylessQuadricMesh::fuse(Corner c) {
  const auto queued = [&](Corner at) {
    return at != kNoCorner && (table_.face(at).queued >> (at & 3) & 1) != 0;
  };
  const Corner left = table_.twin(next(c)), right = table_.twin(previous(c));
  if (has_features_ && (table_.is_line(next(c)) || table_.is_line(previous(c))))
    for (const Corner at : {left, right})
      if (at != kNoCorner) table_.set_line(at);
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
    for_each_line(v, [&](Corner half, std::uint32_t w) { quadrics_[w] -= boundary_quadric(edge(half)); });
  for (const Turn& turn : hand.turns) {
    const SymmetricMatrix after = face_quadric(turn.after);
    own += after;
    const SymmetricMatrix change = after - face_quadric(turn.before);
    quadrics_[table_.vertex(next(turn.corner))] += change;
    quadrics_[table_.vertex(previous(turn.corner))] += change;
  }
}

/// The same for the values, whose sums depend on where the corners were and what values they had.
/// \param along  how much of the new values comes from the end of the half-edge
inline void MemorylessQuadricMesh::update_values(Corner c, const Vec& target, float along, const Hand& hand,
                                                 SymmetricMatrix& own) {
  using Term = MemorylessQuadricValues::Term;
  const std::uint32_t to = table_.vertex(c), from = table_.vertex(next(c));
  const auto merged = values_.between(to, from, std::clamp(along, 0.0f, 1.0f));
  const auto add = [&](std::uint32_t v, const Term& term, float factor) {
    quadrics_[v] += factor * term.form;
    values_.add(v, term, factor);
  };
  const auto term_of = [&](Corner at, const Vec& p, const float* value) {
    const Corner q = next(at), r = previous(at);
    return values_.term(p, position(q), position(r), value, values_.at(table_.vertex(q)),
                        values_.at(table_.vertex(r)));
  };
  for (const Corner side : {c, table_.twin(c)}) {
    if (side == kNoCorner) continue;
    const Corner tip = previous(side);
    add(table_.vertex(tip), term_of(tip, position(tip), values_.at(table_.vertex(tip))), -1);
  }
  Term sum;
  for (const Turn& turn : hand.turns) {
    const Term before = term_of(turn.corner, position(turn.corner), values_.at(table_.vertex(turn.corner)));
    const Term after = term_of(turn.corner, target, merged.data());
    for (const Corner w : {next(turn.corner), previous(turn.corner)}) {
      add(table_.vertex(w), before, -1);
      add(table_.vertex(w), after, 1);
    }
    MemorylessQuadricValues::add(sum, after);
  }
  own += sum.form;
  values_.set(to, merged, sum);
}

inline Collapse MemorylessQuadricMesh::collapse(Corner c, const Placement& placement, const Hand& hand,
                                                std::array<Corner, 2>& unqueued) {
  const std::uint32_t to = table_.vertex(c), from = table_.vertex(next(c));
  const Vec e = edge(c), target = position(c) + placement.offset;
  const Corner d = table_.twin(c);
  const float along = e.squaredNorm() > 0 ? placement.offset.dot(e) / e.squaredNorm() : 0.5f;
  SymmetricMatrix quadric;
  if (!bound_.empty()) bound_.apply(hand.sorting);
  update_ring(c, hand, quadric);
  if (!values_.empty()) update_values(c, target, along, hand, quadric);

  const bool swap = keeps_end(c);
  if (swap) std::swap(input_[from], input_[to]);  // the table merges the end into the start
  unqueued = {fuse(c), d == kNoCorner ? kNoCorner : fuse(d)};
  table_.collapse(c);
  vertices_[to].position = target;
  if (holds_[from] == kFixed) holds_[to] = kFixed;
  if (!weights_.empty()) weights_[to] = std::max(weights_[to], weights_[from]);
  for_each_line(to, [&](Corner half, std::uint32_t w) {
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
