/// \file
/// Lines: edges at the boundary, features and seams, which planes of their own hold in place.
#pragma once

#include <cstdint>

#include "whittle/mq/Mesh.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Vertex.hh"

namespace whittle::mq {

/// How much the square of the distance from a boundary edge or a feature counts.
constexpr float kShapeWeight = 9;
/// The same for a seam, which is to bend little, not to hold the shape. With less the shape is truer and textures slide
/// further; with this they slide at most a fifth further than gltfpack's on the tuning half of the textured models at
/// 25 and 10 %.
constexpr float kSeamWeight = 0.15f;

/// The quadric of the line along a half-edge: the weighted square of the distance from it, whatever the direction.
inline SymmetricMatrix line_quadric(const Mesh& mesh, Corner c) {
  const bool is_only_seam =
      mesh.has_seams && mesh.table.notes(c).is_seam(c) && !mesh.table.notes(c).is_feature(c);
  const float weight = is_only_seam ? kSeamWeight : kShapeWeight;
  const Vec e = mesh.edge(c);
  return SymmetricMatrix::identity(weight * e.squaredNorm()) - SymmetricMatrix::outer(e, weight);
}

/// Calls `visit(half-edge, neighbour)` for the boundary edges, features and seams at `v`.
template <typename Visit>
inline void for_each_line(const Mesh& mesh, std::uint32_t v, Visit visit) {
  const CornerTable& table = mesh.table;
  if (!mesh.has_features && !table.is_open(v) && !(mesh.has_seams && mesh.seams[v] > 0)) return;
  const Corner first = table.first(v);
  Corner at = first, last = first;
  do {
    if (table.twin(at) == kNoCorner || table.notes(at).is_line(at)) visit(at, table.vertex(next(at)));
    last = at;
    at = table.around(at);
  } while (at != kNoCorner && at != first);
  if (at == kNoCorner) visit(previous(last), table.vertex(previous(last)));
}

}  // namespace whittle::mq
