/// \file
/// Seams: lines across which corners differ, in texture say. Vertices move along them only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/mq/Mesh.hh"
#include "whittle/mq/Worker.hh"
#include "whittle/mq/lines.hh"

namespace whittle::mq {

/// Whether a vertex has a ring all around it.
inline bool is_inside(const Mesh& mesh, std::uint32_t v) {
  return mesh.table.first(v) != kNoCorner && !mesh.table.is_open(v);
}

/// Whether a vertex is the end of a slit: it is inside and has a single seam edge. It is fixed, as a slit that
/// becomes shorter closes, and what is apart on its two sides would meet; but see Mesh::joins_spokes.
inline bool ends_slit(const Mesh& mesh, std::uint32_t v) {
  return mesh.seams[v] == 1 && is_inside(mesh, v);
}

/// The chart of each face: some number that only the faces have that hang together across other edges than seams.
inline std::vector<std::uint32_t> charts(const CornerTable& table) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> chart(table.n_faces(), kNone), pending(table.n_faces() + 3);
  for (std::uint32_t seed = 0; seed < chart.size(); ++seed) {
    if (chart[seed] != kNone) continue;
    chart[seed] = seed;
    pending[0] = seed;
    for (std::size_t n = 1; n > 0;) {
      const std::uint32_t f = pending[--n];
      for (Corner c = corner_of(f); c < corner_of(f) + 3;
           ++c) {  // without branches, which nothing could predict
        const Corner d = table.twin(c) == kNoCorner ? c : table.twin(c);
        const std::uint32_t g = face_of(d);
        const std::size_t is_apart = table.notes(c).is_seam(c), is_known = chart[g] != kNone;
        const std::size_t joins = 1 - (is_apart | is_known);
        chart[g] = joins > 0 ? seed : chart[g];
        pending[n] = g;
        n += joins;
      }
    }
  }
  return chart;
}

/// Notes which vertices are on a slit, a seam with one chart on both of its sides.
/// \param seams  a half-edge of each seam edge.
inline void mark_slits(Mesh& mesh, const std::vector<Corner>& seams) {
  const CornerTable& table = mesh.table;
  const std::vector<std::uint32_t> chart = charts(table);
  for (const Corner c : seams)
    if (chart[face_of(c)] == chart[face_of(table.twin(c))])
      for (const std::uint32_t v : {table.vertex(c), table.vertex(next(c))}) mesh.slits[v] |= Mesh::kOnSlit;
}

/// Marks the edges across which the wedges of the two faces differ at either end.
/// \param input_face  for each face its index in the input, and so in `wedges`.
inline void mark_seams(Mesh& mesh, const std::vector<std::array<std::uint32_t, 3>>& wedges,
                       const std::vector<std::uint32_t>& input_face) {
  CornerTable& table = mesh.table;
  std::vector<std::uint32_t> own;  // wedges of each face, and one more that means nothing
  own.reserve(4 * input_face.size());
  for (const std::uint32_t f : input_face) {
    own.insert(own.end(), wedges[f].begin(), wedges[f].end());
    own.push_back(0);
  }
  const auto wedge = [&](Corner c) { return own[std::size_t{4} * face_of(c) + (c & 3)]; };
  std::vector<Corner> seams;
  for (Corner f = 0; f < corner_of(table.n_faces()); f += corner_of(1))
    for (Corner c = f; c < f + 3; ++c) {  // without branches that nothing could predict
      const bool is_open = table.twin(c) == kNoCorner;
      const Corner d = is_open ? c : table.twin(c);
      const std::uint32_t differs = (wedge(c) ^ wedge(next(d))) | (wedge(next(c)) ^ wedge(d));
      if (is_open || differs == 0) continue;
      table.notes(c).set_seam(c);
      if (c < d) seams.push_back(c);
    }
  if (seams.empty()) return;
  mesh.has_seams = mesh.has_lines = true;
  mesh.all_free = false;
  mesh.seams.assign(table.n_vertices(), 0);
  for (const Corner c : seams)
    for (const std::uint32_t v : {table.vertex(c), table.vertex(next(c))}) ++mesh.seams[v];
  for (const Corner c : seams) {
    if (table.notes(c).is_feature(c)) continue;
    const SymmetricMatrix line = line_quadric(mesh, c);
    for (const std::uint32_t v : {table.vertex(c), table.vertex(next(c))}) mesh.quadrics[v] += line;
  }
  mesh.slits.assign(table.n_vertices(), 0);
  for (std::uint32_t v = 0; v < mesh.seams.size(); ++v) {
    if (mesh.holds[v] != kFree) mesh.slits[v] = Mesh::kHeldAnyway;
    if (ends_slit(mesh, v)) mesh.holds[v] = kFixed;
  }
  mark_slits(mesh, seams);
}

/// Whether the face of `c` is a chart by itself: across each of its edges is a seam or the boundary.
inline bool is_chart(const Mesh& mesh, Corner c) {
  const auto ends = [&](Corner at) {
    return mesh.table.twin(at) == kNoCorner || mesh.table.notes(at).is_seam(at);
  };
  return ends(c) && ends(next(c)) && ends(previous(c));
}

/// Whether the collapse of an edge leaves the seams in their places. Two vertices on seams merge along a seam,
/// or along the boundary where the chart between them is a single face, which vanishes.
inline bool keeps_seams(const Mesh& mesh, Corner c) {
  const std::uint32_t a = mesh.table.vertex(c), b = mesh.table.vertex(next(c));
  if (mesh.seams[a] == 0 && mesh.seams[b] == 0) return true;
  if (mesh.is_slit_end(a) && mesh.is_slit_end(b)) return mesh.joins_spokes(c);
  if (mesh.hold(a, b) + mesh.hold(b, a) > kFixed) return false;
  if (mesh.seams[a] == 0 || mesh.seams[b] == 0) return true;
  const Corner d = mesh.table.twin(c);
  if (mesh.keeps_charts && (is_chart(mesh, c) || (d != kNoCorner && is_chart(mesh, d)))) return false;
  return d == kNoCorner ? is_chart(mesh, c) : mesh.table.notes(c).is_seam(c);
}

/// Whether the collapse of a seam edge drags a chart of one face along: moves a corner of it by more than half of the
/// edge opposite. The lines of a small chart weigh little, so it would cost next to nothing to move it anywhere.
/// \param offset  of the new vertex from the start of the edge; the worker has its ring.
inline bool drags_chart(const Mesh& mesh, Corner c, const Vec& offset, const Worker& worker) {
  if (!mesh.table.notes(c).is_seam(c)) return false;
  const float squares[] = {offset.squaredNorm(), (offset - mesh.edge(c)).squaredNorm()};
  for (std::size_t i = 0; i < worker.ring.size(); ++i) {
    const Corner corner = worker.ring.begin()[i].corner;
    const float square = squares[i < worker.ring.n_at_start() ? 0 : 1];
    if (is_chart(mesh, corner) && 4 * square > mesh.edge(next(corner)).squaredNorm()) return true;
  }
  return false;
}

/// Whether the collapse of an edge takes the last vertex between a slit's two ends, all of which are the worker's.
inline bool closes_slit(const Mesh& mesh, Corner c) {
  const auto is_last = [&](std::uint32_t end, std::uint32_t middle) {
    if (!ends_slit(mesh, end) || mesh.seams[middle] != 2) return false;
    bool ends_other = true;
    for_each_line(mesh, middle, [&](Corner half, std::uint32_t w) {
      if (mesh.table.notes(half).is_seam(half) && w != end) ends_other = ends_slit(mesh, w);
    });
    return ends_other;
  };
  const std::uint32_t a = mesh.table.vertex(c), b = mesh.table.vertex(next(c));
  return mesh.table.notes(c).is_seam(c) && (is_last(a, b) || is_last(b, a));
}

/// What the collapse of an edge makes of the seams; the table has yet to change. Of each face that vanishes two
/// edges become one: a seam if either was, unless it is at the boundary now.
///
/// A chart of one face is gone with it. Where its tip is on no other seam, one chart surrounds the tip, and
/// so lies on both sides of the edge: that is no seam any more. An exception is on a slit, whose two sides do not
/// agree at the survivor.
inline void fuse_seams(Mesh& mesh, Corner c) {
  CornerTable& table = mesh.table;
  const std::uint32_t to = table.vertex(c), from = table.vertex(next(c));
  const bool is_open = table.is_open(to) || table.is_open(from);
  std::vector<std::uint32_t>& seams = mesh.seams;
  mesh.slits[to] |= mesh.slits[from];
  if (seams[to] + seams[from] == 0) return;
  seams[to] += seams[from];
  seams[from] = 0;
  if (table.notes(c).is_seam(c)) seams[to] -= 2;
  const auto clear = [&](Corner side) {
    for (const Corner at : {table.twin(next(side)), table.twin(previous(side))})
      if (at != kNoCorner) table.notes(at).clear_seam(at);
    --seams[to];
    --seams[table.vertex(previous(side))];
  };

  const std::array<Corner, 2> sides = {c, table.twin(c)};
  std::array<bool, 2> closes = {};
  std::uint32_t n_closing = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Corner side = sides[i];
    if (side == kNoCorner) continue;
    const Corner left = table.twin(next(side)), right = table.twin(previous(side));
    const bool at_left = table.notes(side).is_seam(next(side)),
               at_right = table.notes(side).is_seam(previous(side));
    if (!at_left && !at_right) continue;
    if (left == kNoCorner || right == kNoCorner) {
      clear(side);
      continue;
    }
    table.notes(left).set_seam(left);
    table.notes(right).set_seam(right);
    if (!at_left || !at_right) continue;
    const std::uint32_t tip = table.vertex(previous(side));
    --seams[to];
    --seams[tip];
    closes[i] = seams[tip] == 1 && is_inside(mesh, tip);
    n_closing += closes[i];
  }
  const bool on_slit = (mesh.slits[to] & Mesh::kOnSlit) != 0;
  const bool leaves_slit = on_slit || (!is_open && seams[to] == n_closing + 1);
  for (std::size_t i = 0; i < 2; ++i)
    if (closes[i] && !leaves_slit) clear(sides[i]);

  if (seams[to] == 1 && !is_open) mesh.holds[to] = kFixed;
  for (const Corner side : sides)
    if (side != kNoCorner && ends_slit(mesh, table.vertex(previous(side))))
      mesh.holds[table.vertex(previous(side))] = kFixed;
}

}  // namespace whittle::mq
