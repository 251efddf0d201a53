/// \file
/// The state of mq: the mesh as the plan so far leaves it, with a quadric at each vertex.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/mq/Bound.hh"
#include "whittle/mq/Corner.hh"
#include "whittle/mq/FaceNotes.hh"
#include "whittle/mq/Partition.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Values.hh"
#include "whittle/mq/Vertex.hh"

namespace whittle::mq {

/// A copy of the input of unit size in floats, renumbered along a Morton curve. `build` makes it, `place` and
/// `judge` read it, `collapse` changes it.
///
/// Several threads may judge and collapse at once, each in a part of its own: it touches nothing but the
/// part's vertices and faces. Of other faces it reads only which part they are in, and that changes only when
/// one thread works alone.
struct Mesh {
  CornerTable table;
  Partition partition;
  // Of each vertex:
  std::vector<Vertex> vertices;
  std::vector<SymmetricMatrix> quadrics;
  std::vector<AreaVector> areas;  ///< sums over its faces
  std::vector<Hold> holds;
  std::vector<float> weights;        ///< factors of costs; empty where all are 1
  std::vector<std::uint32_t> seams;  ///< how many of its edges are seams; empty unless has_seams
  std::vector<std::uint8_t> slits;   ///< kOnSlit, kHeldAnyway; empty unless has_seams
  std::vector<std::uint32_t> input;  ///< its index in the input

  Values values;               ///< may be empty
  std::optional<Bound> bound;  ///< on the distance from the input
  float min_cos = -1;          ///< of the flip guard
  bool all_free = true;        ///< `holds` is kFree everywhere, and there are no seams
  bool has_boundary = false;   ///< open vertices
  bool has_features = false;   ///< edges that are marked as features
  bool has_seams = false;      ///< edges that are marked as seams
  bool has_lines = false;      ///< edges with planes of their own: boundary, features, seams
  bool keeps_charts = false;   ///< no chart loses its last face
  double scale = 1;            ///< the input's coordinates: scale times position plus center
  Eigen::Vector3d center = Eigen::Vector3d::Zero();

  /// In `slits`: whether a vertex, or what has merged into it, is on a seam with one chart on both sides; and whether
  /// something else than a slit holds it.
  static constexpr std::uint8_t kOnSlit = 1, kHeldAnyway = 2;

  const Vec& position(Corner c) const { return vertices[table.vertex(c)].position; }
  EIGEN_ALWAYS_INLINE Vec edge(Corner c) const { return position(next(c)) - position(c); }

  /// Whether only a slit that ends at a vertex holds it.
  bool is_slit_end(std::uint32_t v) const {
    return seams[v] == 1 && holds[v] == kFixed && (slits[v] & kHeldAnyway) == 0;
  }
  /// Whether an edge is between the outer ends of two spokes, slits of one edge that meet at a hub, and closes the face
  /// between them: the two become one. So do those around the pole of a sphere, where each face has a coordinate of its
  /// own. Three of them stay.
  bool joins_spokes(Corner c) const {
    if (!is_slit_end(table.vertex(c)) || !is_slit_end(table.vertex(next(c))) || table.notes(c).is_seam(c))
      return false;
    for (const Corner side : {c, table.twin(c)})
      if (side != kNoCorner && table.notes(side).is_seam(next(side)) &&
          table.notes(side).is_seam(previous(side)) && seams[table.vertex(previous(side))] > 3)
        return true;
    return false;
  }
  /// Whether `v` stays where it is when its edge to `other` collapses. A vertex on a seam moves along the
  /// seam only, and where the seam meets the boundary along the boundary only; the outer ends of spokes move together.
  Hold hold(std::uint32_t v, std::uint32_t other) const {
    if (!has_seams || seams[v] == 0) return holds[v];
    if (holds[v] != kFree) return is_slit_end(v) && is_slit_end(other) ? kFree : holds[v];
    return seams[other] == 0 || (has_boundary && table.is_open(v) && !table.is_open(other)) ? kFixed : kFree;
  }
  /// Both ends have a ring, and not both are fixed.
  bool is_movable(Corner c) const {
    if (all_free) return true;
    const Hold a = holds[table.vertex(c)], b = holds[table.vertex(next(c))];
    return a + b <= kFixed || (has_seams && joins_spokes(c));
  }
  /// Whether the end of the half-edge survives rather than its start: it is held, or it alone is on a seam or
  /// on the boundary.
  bool keeps_end(Corner c) const {
    const std::uint32_t start = table.vertex(c), end = table.vertex(next(c));
    return hold(end, start) == kFixed || (table.is_open(end) && !table.is_open(start));
  }
  void update_part(Corner c) { table.notes(c).part = partition.part_of(table.face(c).vertex); }
};

}  // namespace whittle::mq
