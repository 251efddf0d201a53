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

#include "whittle/mq/CornerTable.hh"
#include "whittle/mq/Four.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/PackedNormal.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/plan/CollapsePlan.hh"

namespace whittle {

inline auto MemorylessQuadricMesh::place(const std::array<Corner, 4>& corners) const -> Placements {
  FourEdges edges;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t a = table_.vertex(corners[i]), b = table_.vertex(next(corners[i]));
    edges.start[i] = a;
    edges.end[i] = b;
    edges.at_start[i] = &quadrics_[a];
    edges.at_end[i] = &quadrics_[b];
  }
  if (values_.empty()) return best_places(edges);
  std::array<SymmetricMatrix, 8> sums;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t a = edges.start[i], b = edges.end[i];
    const Vec e = edge(corners[i]);
    edges.at_start[i] = &(sums[i] = quadrics_[a] + values_.along(a, b, e, a));
    edges.at_end[i] = &(sums[4 + i] = quadrics_[b] + values_.along(a, b, e, b));
  }
  return best_places(edges);
}

/// Minimises the sum of the squared distances to both ends' planes, u Ha u + (u - e) Hb (u - e), with a
/// slight pull to the middle that decides where the planes leave a direction open.
inline auto MemorylessQuadricMesh::best_places(const FourEdges& edges) const -> Placements {
  std::array<const float*, 4> starts, ends;
  for (std::size_t i = 0; i < 4; ++i) {
    starts[i] = vertices_[edges.start[i]].position.data();
    ends[i] = vertices_[edges.end[i]].position.data();
  }
  const FourVectors e = gathered(ends) - gathered(starts);
  const FourMatrices at_b = gathered(edges.at_end), sum = gathered(edges.at_start) + at_b;
  const FourVectors pull_b = at_b * e;
  const Four pull = 1e-5f * sum.trace();
  const FourVectors middle = Four(0.5f) * e;
  FourVectors pivots = e;
  const FourVectors u = (sum + FourMatrices::identity(pull)).solve(pull_b + pull * middle, pivots);
  const FourVectors off = u - middle;
  const Four cost = (e - u).dot(pull_b) - pull * u.dot(off);
  const Four least = pivots.x().min(pivots.y()).min(pivots.z()),
             far = 4 * e.squaredNorm() - off.squaredNorm();
  Placements placements;
  Eigen::Matrix4f::Map(&placements[0].offset.x()) = transposed(u.x(), u.y(), u.z(), cost.max(0.0f));

  // Zero times anything that is not finite is not zero.
  const bool irregular = !(least.min(far).minCoeff() > 0 && (0 * (least + far)).sum() == 0);
  if (irregular || !all_free_ || !weights_.empty())
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t start = edges.start[i], end = edges.end[i];
      const auto k = static_cast<Eigen::Index>(i);
      if (holds_[start] + holds_[end] != kFree || !(least[k] > 0 && far[k] >= 0))
        placements[i] = safe_place(vertices_[end].position - vertices_[start].position, holds_[start],
                                   holds_[end], *edges.at_start[i], *edges.at_end[i]);
      if (!weights_.empty()) placements[i].cost *= std::max(weights_[start], weights_[end]);
    }
  return placements;
}

/// At the end that is held, or in the middle.
inline auto MemorylessQuadricMesh::safe_place(const Vec& e, Hold a, Hold b, const SymmetricMatrix& at_a,
                                              const SymmetricMatrix& at_b) -> Placement {
  if (a == kFixed) return {Vec::Zero(), std::max(0.0f, e.dot(at_b * e))};
  if (b == kFixed) return {e, std::max(0.0f, e.dot(at_a * e))};
  const Vec middle = e / 2;
  return {middle, std::max(0.0f, middle.dot((at_a + at_b) * middle))};
}

/// Goes around the vertex where half-edge `c` starts and its twin `d` ends, one of which may be missing:
/// shows the other neighbours to `visit`, and collects the faces that stay when they collapse.
/// \return  false  the ring leaves the hand's part.
template <typename Visit>
bool MemorylessQuadricMesh::survey(Corner c, Corner d, Hand& hand, Visit visit) {
  if (c != kNoCorner) {
    const Corner end = d == kNoCorner ? kNoCorner : next(d);
    std::uint32_t w = table_.vertex(previous(c));
    visit(vertices_[w]);
    Corner at = table_.around(c);
    while (at != end && at != kNoCorner) {
      const Corner back = previous(at);
      const std::uint32_t after = table_.vertex(back);  // the neighbour that comes next
      if (!hand.has(after)) return false;
      hand.ring.add({w, after, at, table_.face(at).normal});
      visit(vertices_[after]);
      w = after;
      at = table_.twin(back);
    }
    if (at == end) return true;
  }
  // An open fan: the rest of it is on the other side.
  std::uint32_t w = table_.vertex(previous(d));
  visit(vertices_[w]);
  for (Corner back = table_.twin(next(d)); back != kNoCorner;) {
    const Corner at = next(back);
    const std::uint32_t before = table_.vertex(next(at));
    if (!hand.has(before)) return false;
    hand.ring.add({before, w, at, table_.face(at).normal});
    visit(vertices_[before]);
    w = before;
    back = table_.twin(at);
  }
  return true;
}

inline auto MemorylessQuadricMesh::judge(Corner c, const Placement& placement, Hand& hand) -> Verdict {
  const Corner d = table_.twin(c);
  const std::uint32_t a = table_.vertex(c), b = table_.vertex(next(c));
  const bool a_open = table_.is_open(a), b_open = table_.is_open(b), interior = d != kNoCorner;
  if (interior) {
    if (a_open && b_open) return Verdict::illegal;  // the boundary would touch itself
    const std::uint32_t tip = table_.vertex(previous(d));
    if (!hand.has(tip)) return Verdict::elsewhere;
    if (tip == table_.vertex(previous(c))) return Verdict::illegal;
  }
  if ((a_open && !b_open && holds_[b] != kFree) || (b_open && !a_open && holds_[a] != kFree))
    return Verdict::illegal;  // the boundary would leave its place

  const std::uint32_t mark = hand.stamp += hand.stride;
  vertices_[a].mark = vertices_[b].mark = mark;
  hand.ring.clear();
  std::size_t common = 0;
  if (!survey(c, d, hand, [&](Vertex& v) { v.mark = mark; })) return Verdict::elsewhere;
  hand.ring.turn_over();
  const auto count = [&](Vertex& v) {
    common += v.mark == mark;
    v.mark = mark;
  };
  if (!survey(d, c, hand, count)) return Verdict::elsewhere;
  if (common != (interior ? 2u : 1u)) return Verdict::illegal;
  const std::size_t of_a = hand.ring.n_at_start(), of_b = hand.ring.size() - of_a;
  const bool ear = (keeps_end(c) ? of_a : of_b) == 0;                                  // its tip would vanish
  const bool back_to_back = interior && !a_open && !b_open && of_a <= 1 && of_b <= 1;  // two faces would be
  if (ear || back_to_back) return Verdict::illegal;
  const Vec target = position(c) + placement.offset;
  if (!hand.ring.turn(vertices_, a, b, target, min_cos_ * std::abs(min_cos_))) return Verdict::illegal;
  return bound_.empty() || keeps_bound(c, target, hand) ? Verdict::legal : Verdict::illegal;
}

/// Whether the points of the faces around the edge, those of the ring and those that vanish, stay near.
inline bool MemorylessQuadricMesh::keeps_bound(Corner c, const Vec& target, Hand& hand) const {
  auto& sorting = hand.sorting;
  sorting.clear();
  for (const Corner side : {c, table_.twin(c)})
    if (side != kNoCorner) sorting.faces.push_back(face_of(side));
  for (const auto& side : hand.ring) {
    const std::uint32_t face = face_of(side.corner);
    sorting.faces.push_back(face);
    sorting.triangles.push_back({face, target, vertices_[side.from].position, vertices_[side.to].position});
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
  if (has_lines_)
    for (const std::uint32_t v : {table_.vertex(c), table_.vertex(next(c))})
      for_each_line(v, [&](Corner half, std::uint32_t w) { quadrics_[w] -= boundary_quadric(edge(half)); });
  own += hand.ring.update([&](std::uint32_t v, const SymmetricMatrix& change) { quadrics_[v] += change; });
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
  for (const auto& side : hand.ring) {
    const Term before = term_of(side.corner, position(side.corner), values_.at(table_.vertex(side.corner)));
    const Term after = term_of(side.corner, target, merged.data());
    for (const std::uint32_t w : {side.from, side.to}) {
      add(w, before, -1);
      add(w, after, 1);
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
  if (has_lines_)
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
