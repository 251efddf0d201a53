/// \file
/// A thread's share of the mesh, and its working memory.
#pragma once

#include <cstdint>

#include "whittle/mq/Bound.hh"
#include "whittle/mq/EdgeRing.hh"
#include "whittle/mq/FaceNotes.hh"
#include "whittle/mq/Partition.hh"

namespace whittle::mq {

/// The part that a thread works in; or the whole mesh, where it works alone. And what `judge` has found about
/// the last edge, which `collapse` needs.
struct Worker {
  PartNumber part = kNoPart;
  std::uint32_t begin = 0, size = 0xffffffffu;  ///< its vertices
  std::uint32_t stamp = 0, stride = 1;  ///< the last mark that it has set; no other worker sets the same
  EdgeRing ring = {};                   ///< around the edge that was judged last
  Bound::Change change = {};            ///< of the same, where there is a bound

  /// \param number  of a part, or kNoPart for the whole mesh.
  Worker(const Partition& partition, PartNumber number)
      : part(number), stamp(number), stride(partition.size() + 1u) {
    if (part == kNoPart) return;
    begin = partition.first_vertex(part);
    size = partition.first_vertex(part + 1u) - begin;
  }

  bool has(std::uint32_t v) const { return v - begin < size; }
};

}  // namespace whittle::mq
