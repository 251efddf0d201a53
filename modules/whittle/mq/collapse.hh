/// \file
/// What the collapse of an edge changes.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "whittle/mq/Mesh.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Worker.hh"
#include "whittle/mq/lines.hh"
#include "whittle/mq/place.hh"
#include "whittle/mq/seams.hh"
#include "whittle/plan/CollapsePlan.hh"

namespace whittle::mq {

/// \param normal  twice the face's area long.
inline SymmetricMatrix face_quadric(const Vec& normal) {
  const float length = normal.norm();
  return length > 0 ? SymmetricMatrix::outer(normal, 1 / length) : SymmetricMatrix();
}

/// The face of `c` is about to vanish and its two other edges are about to become one, which shall be queued
/// once if either of them is.
/// \return a half-edge of it that has yet to be queued, or kNoCorner.
inline Corner fuse(Mesh& mesh, Corner c) {
  CornerTable& table = mesh.table;
  const auto queued = [&](Corner at) { return at != kNoCorner && table.notes(at).is_queued(at); };
  const Corner left = table.twin(next(c)), right = table.twin(previous(c));
  if (mesh.has_features && (table.notes(c).is_feature(next(c)) || table.notes(c).is_feature(previous(c))))
    for (const Corner at : {left, right})
      if (at != kNoCorner) table.notes(at).set_feature(at);
  if (queued(left) && queued(right)) table.notes(right).clear_queued(right);
  if (queued(left) || queued(right) || !(queued(next(c)) || queued(previous(c)))) return kNoCorner;
  return left != kNoCorner ? left : right;
}

/// Takes out of the ring's quadrics and areas what vanishes or changes with the collapse of `c`, and puts in what the
/// faces that remain become.
/// \param own  gains the survivor's faces.
inline void update_ring(Mesh& mesh, Corner c, const Worker& worker, SymmetricMatrix& own) {
  for (const Corner side : {c, mesh.table.twin(c)}) {
    if (side == kNoCorner) continue;
    const Corner tip = previous(side);
    const Vec normal = mesh.edge(side).cross(-mesh.edge(tip));
    mesh.quadrics[mesh.table.vertex(tip)] -= face_quadric(normal);
    mesh.areas[mesh.table.vertex(tip)].sum -= normal;
  }
  if (mesh.has_lines)
    for (const std::uint32_t v : {mesh.table.vertex(c), mesh.table.vertex(next(c))})
      for_each_line(mesh, v,
                    [&](Corner half, std::uint32_t w) { mesh.quadrics[w] -= line_quadric(mesh, half); });
  const EdgeRing::Sums sums =
      worker.ring.update([&](std::uint32_t v, const SymmetricMatrix& quadric, const Vec& area) {
        mesh.quadrics[v] += quadric;
        mesh.areas[v].sum += area;
      });
  own += sums.quadric;
  mesh.areas[mesh.table.vertex(c)].sum = sums.area;
}

/// The same for the values, whose terms depend on where the corners were and what values they had.
/// \param along  the share of the end of the half-edge in the new values.
inline void update_values(Mesh& mesh, Corner c, const Vec& target, float along, const Worker& worker,
                          SymmetricMatrix& own) {
  const CornerTable& table = mesh.table;
  Values& values = mesh.values;
  const std::uint32_t to = table.vertex(c), from = table.vertex(next(c));
  const auto merged = values.between(to, from, std::clamp(along, 0.0f, 1.0f));
  const auto add = [&](std::uint32_t v, const Values::Term& term) {
    mesh.quadrics[v] += term.form;
    values.add(v, term);
  };
  const auto subtract = [&](std::uint32_t v, const Values::Term& term) {
    mesh.quadrics[v] -= term.form;
    values.subtract(v, term);
  };
  const auto position = [&](std::uint32_t v) -> const Vec& { return mesh.vertices[v].position; };
  const auto put = [&](Values::FourFaces& faces, std::size_t k, std::uint32_t p, std::uint32_t q,
                       std::uint32_t r) {
    faces.p[k] = position(p).data();
    faces.q[k] = position(q).data();
    faces.r[k] = position(r).data();
    faces.at_p[k] = values.at(p);
    faces.at_q[k] = values.at(q);
    faces.at_r[k] = values.at(r);
  };
  Values::FourFaces faces;
  std::array<Values::Term, 4> before, after;
  const Corner d = table.twin(c) == kNoCorner ? c : table.twin(c);
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner side = k == 1 ? d : c;
    put(faces, k, table.vertex(previous(side)), table.vertex(side), table.vertex(next(side)));
  }
  values.terms(faces, before);
  subtract(table.vertex(previous(c)), before[0]);
  if (d != c) subtract(table.vertex(previous(d)), before[1]);

  // A face that lacks all values at a corner adds nothing.
  const Vertex moved{target, 0};
  Values::Term sum = values.no_term();
  std::array<const EdgeRing::Side*, 4> sides;
  const auto apply = [&](std::size_t n) {
    for (std::size_t k = n; k < 4; ++k) put(faces, k, to, sides[0]->from, sides[0]->to);
    values.terms(faces, before);
    faces.p.fill(moved.position.data());
    faces.at_p.fill(merged.data());
    values.terms(faces, after);
    for (std::size_t k = 0; k < n; ++k) {
      for (const std::uint32_t w : {sides[k]->from, sides[k]->to}) {
        subtract(w, before[k]);
        add(w, after[k]);
      }
      values.add(sum, after[k]);
    }
  };
  std::size_t n = 0;
  for (std::size_t i = 0; i < worker.ring.size(); ++i) {
    const EdgeRing::Side& side = worker.ring.begin()[i];
    const std::uint32_t p = i < worker.ring.n_at_start() ? to : from;
    if ((values.known(p) & values.known(side.from) & values.known(side.to)) == 0) continue;
    put(faces, n, p, side.from, side.to);
    sides[n++] = &side;
    if (n < 4) continue;
    apply(n);
    n = 0;
  }
  if (n > 0) apply(n);
  own += sum.form;
  values.set(to, merged, sum);
}

/// Whether the vertex with very many faces is the end of a half-edge either of whose ends may survive. It survives then:
/// who carries the plan out goes around the vertex that vanishes, and would go around this one again and again.
inline bool is_hub_at_end(const Mesh& mesh, Corner c, const Worker& worker) {
  constexpr std::size_t kMany = 64;
  const std::size_t at_start = worker.ring.n_at_start(), at_end = worker.ring.size() - at_start;
  if (at_end < at_start + kMany || at_start == 0) return false;
  const std::uint32_t start = mesh.table.vertex(c), end = mesh.table.vertex(next(c));
  return mesh.hold(start, end) == kFree && (mesh.table.is_open(end) || !mesh.table.is_open(start));
}

/// Collapses the edge that the worker has just judged.
/// \param unqueued  half-edges of two queued edges that have become one, which is not queued; or kNoCorner.
inline Collapse collapse(Mesh& mesh, Corner c, const Placement& placement, const Worker& worker,
                         std::array<Corner, 2>& unqueued) {
  CornerTable& table = mesh.table;
  const std::uint32_t to = table.vertex(c), from = table.vertex(next(c));
  const Vec e = mesh.edge(c), target = mesh.position(c) + placement.offset;
  const Corner d = table.twin(c);
  const float along = e.squaredNorm() > 0 ? placement.offset.dot(e) / e.squaredNorm() : 0.5f;
  SymmetricMatrix quadric;
  if (mesh.bound) mesh.bound->apply(worker.change);
  update_ring(mesh, c, worker, quadric);
  if (!mesh.values.empty()) update_values(mesh, c, target, along, worker, quadric);

  if (mesh.keeps_end(c) || is_hub_at_end(mesh, c, worker))
    std::swap(mesh.input[from], mesh.input[to]);  // the table merges the end into the start
  unqueued = {fuse(mesh, c), d == kNoCorner ? kNoCorner : fuse(mesh, d)};
  if (mesh.has_seams) fuse_seams(mesh, c);
  table.collapse(c);
  table.notes(c).clear_edges();  // so that a queue can skip it without asking whether its face is dead
  if (d != kNoCorner) table.notes(d).clear_edges();
  mesh.vertices[to].position = target;
  if (mesh.holds[from] == kFixed) mesh.holds[to] = kFixed;
  if (!mesh.weights.empty()) mesh.weights[to] = std::max(mesh.weights[to], mesh.weights[from]);
  if (mesh.has_lines)
    for_each_line(mesh, to, [&](Corner half, std::uint32_t w) {
      const SymmetricMatrix line = line_quadric(mesh, half);
      mesh.quadrics[w] += line;
      quadric += line;
    });
  mesh.quadrics[to] = quadric;
  if (worker.part == kNoPart) {
    Corner at = table.first(to);
    do {
      mesh.update_part(at);
      at = table.around(at);
    } while (at != kNoCorner && at != table.first(to));
  }
  return {mesh.input[from], mesh.input[to], d == kNoCorner ? 1u : 2u, 0,
          mesh.center + mesh.scale * target.cast<double>()};
}

}  // namespace whittle::mq
