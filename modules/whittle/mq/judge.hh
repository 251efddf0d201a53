/// \file
/// Whether an edge may collapse: link condition, seams, flip guard, bound.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "whittle/mq/Mesh.hh"
#include "whittle/mq/Worker.hh"
#include "whittle/mq/place.hh"
#include "whittle/mq/seams.hh"

namespace whittle::mq {

enum class Verdict {
  legal,
  elsewhere,     ///< the ring leaves the worker's part
  breaks_link,   ///< the link condition, or a rule of the boundary
  turns_face,    ///< the flip guard
  breaks_seam,   ///< a seam would move sideways, or a chart vanish that shall not
  breaks_bound,  ///< the largest distance
};

/// Whether an edge has been judged around either end since the worker had that stamp.
inline bool is_touched(const Mesh& mesh, Corner c, const Worker& worker, std::uint32_t since) {
  const auto is_later = [&](std::uint32_t v) {
    return mesh.vertices[v].mark - since - 1 < worker.stamp - since;
  };
  return is_later(mesh.table.vertex(c)) || is_later(mesh.table.vertex(next(c)));
}

/// Goes around the vertex where half-edge `c` starts and its twin `d` ends, one of which may be missing:
/// shows the other neighbours to `visit`, and collects the faces that remain when they collapse.
/// \return false  the ring leaves the worker's part.
template <typename Visit>
inline bool survey(Mesh& mesh, Corner c, Corner d, Worker& worker, Visit visit) {
  const CornerTable& table = mesh.table;
  auto& vertices = mesh.vertices;
  if (c != kNoCorner) {
    const Corner end = d == kNoCorner ? kNoCorner : next(d);
    std::uint32_t w = table.vertex(previous(c));
    visit(vertices[w]);
    Corner at = table.around(c);
    while (at != end && at != kNoCorner) {
      const Corner back = previous(at);
      const std::uint32_t after = table.vertex(back);  // the neighbour that comes next
      if (!worker.has(after)) return false;
      worker.ring.add({w, after, at, table.notes(at).normal});
      visit(vertices[after]);
      w = after;
      at = table.twin(back);
    }
    if (at == end) return true;
  }
  // An open fan: the rest of it is on the other side.
  std::uint32_t w = table.vertex(previous(d));
  visit(vertices[w]);
  for (Corner back = table.twin(next(d)); back != kNoCorner;) {
    const Corner at = next(back);
    const std::uint32_t before = table.vertex(next(at));
    if (!worker.has(before)) return false;
    worker.ring.add({before, w, at, table.notes(at).normal});
    visit(vertices[before]);
    w = before;
    back = table.twin(at);
  }
  return true;
}

/// Whether the points of the faces around the edge, those of the ring and those that vanish, stay near.
inline bool keeps_bound(const Mesh& mesh, Corner c, const Vec& target, Worker& worker) {
  auto& change = worker.change;
  change.clear();
  for (const Corner side : {c, mesh.table.twin(c)})
    if (side != kNoCorner) change.faces.push_back(face_of(side));
  for (const auto& side : worker.ring) {
    const std::uint32_t face = face_of(side.corner);
    change.faces.push_back(face);
    change.triangles.push_back(
        {face, target, mesh.vertices[side.from].position, mesh.vertices[side.to].position});
  }
  return mesh.bound->allows(change);
}

/// Judges the collapse of an edge and leaves its ring in the worker, for `collapse`. Marks the vertices
/// around it. The link condition: the ends have no neighbours in common but those opposite the edge.
/// \param may_drag  whether charts of one face may be dragged along, as what costs less has been done.
inline Verdict judge(Mesh& mesh, Corner c, const Placement& placement, Worker& worker,
                     bool may_drag = false) {
  const CornerTable& table = mesh.table;
  const Corner d = table.twin(c);
  const std::uint32_t a = table.vertex(c), b = table.vertex(next(c));
  const bool a_open = table.is_open(a), b_open = table.is_open(b), interior = d != kNoCorner;
  if (interior) {
    if (a_open && b_open) return Verdict::breaks_link;  // the boundary would touch itself
    const std::uint32_t tip = table.vertex(previous(d));
    if (!worker.has(tip)) return Verdict::elsewhere;
    if (tip == table.vertex(previous(c))) return Verdict::breaks_link;
  }
  if (mesh.has_seams && !keeps_seams(mesh, c)) return Verdict::breaks_seam;
  if ((a_open && !b_open && mesh.hold(b, a) != kFree) || (b_open && !a_open && mesh.hold(a, b) != kFree))
    return Verdict::breaks_link;  // the boundary would leave its place

  const std::uint32_t mark = worker.stamp += worker.stride;
  mesh.vertices[a].mark = mesh.vertices[b].mark = mark;
  worker.ring.clear();
  std::size_t common = 0;
  if (!survey(mesh, c, d, worker, [&](Vertex& v) { v.mark = mark; })) return Verdict::elsewhere;
  worker.ring.begin_second_end();
  const auto count = [&](Vertex& v) {
    common += v.mark == mark;
    v.mark = mark;
  };
  if (!survey(mesh, d, c, worker, count)) return Verdict::elsewhere;
  if (common != (interior ? 2u : 1u)) return Verdict::breaks_link;
  if (mesh.has_seams &&
      (closes_slit(mesh, c) || (!may_drag && drags_chart(mesh, c, placement.offset, worker))))
    return Verdict::breaks_seam;
  const std::size_t of_a = worker.ring.n_at_start(), of_b = worker.ring.size() - of_a;
  const bool ear = (mesh.keeps_end(c) ? of_a : of_b) == 0;                             // its tip would vanish
  const bool back_to_back = interior && !a_open && !b_open && of_a <= 1 && of_b <= 1;  // two faces would be
  if (ear || back_to_back) return Verdict::breaks_link;
  const Vec target = mesh.position(c) + placement.offset;
  if (!worker.ring.turn(mesh.vertices, a, b, target, mesh.min_cos * std::abs(mesh.min_cos)))
    return Verdict::turns_face;
  return !mesh.bound || keeps_bound(mesh, c, target, worker) ? Verdict::legal : Verdict::breaks_bound;
}

}  // namespace whittle::mq
