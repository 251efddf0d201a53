/// \file
/// Lines: edges at the boundary and features, which planes of their own hold in place.
#pragma once

#include <cstdint>

#include "whittle/mq/Mesh.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Vertex.hh"

namespace whittle::mq {

/// The quadric of a line along `e`: nine times the square of the distance from it, whatever the direction.
inline SymmetricMatrix line_quadric(const Vec& e) {
  return SymmetricMatrix::identity(9 * e.squaredNorm()) - SymmetricMatrix::outer(e, 9.0f);
}

/// Calls `visit(half-edge, neighbour)` for the boundary and feature edges at `v`.
template <typename Visit>
inline void for_each_line(const Mesh& mesh, std::uint32_t v, Visit visit) {
  const CornerTable& table = mesh.table;
  if (!mesh.has_features && !table.is_open(v)) return;
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
