/// \file
/// What mq keeps of a face beside its place in the corner table.
#pragma once

#include <cstdint>

#include "whittle/mq/CornerTable.hh"
#include "whittle/mq/PackedNormal.hh"

namespace whittle::mq {

/// A part of the mesh that one thread works in, counted from 1; or none: of a face between parts.
using PartNumber = std::uint16_t;
constexpr PartNumber kNoPart = 0;

/// Eight bytes that ride in each face of the corner table.
class FaceNotes {
 public:
  PackedNormal normal;  ///< in the input
  PartNumber part = kNoPart;

  bool is_queued(Corner c) const { return (edges_ >> (c & 3) & 1) != 0; }
  void set_queued(Corner c) { edges_ |= bit_of(c); }
  void clear_queued(Corner c) { edges_ &= static_cast<std::uint16_t>(~bit_of(c)); }

  /// A line is an edge that planes of its own hold in place: a feature, a seam, or both. Both half-edges are
  /// marked.
  bool is_line(Corner c) const { return (edges_ >> (3 + (c & 3)) & 9) != 0; }
  bool is_feature(Corner c) const { return (edges_ >> (3 + (c & 3)) & 1) != 0; }
  void set_feature(Corner c) { edges_ |= static_cast<std::uint16_t>(8u << (c & 3)); }
  bool is_seam(Corner c) const { return (edges_ >> (6 + (c & 3)) & 1) != 0; }
  void set_seam(Corner c) { edges_ |= static_cast<std::uint16_t>(64u << (c & 3)); }
  void clear_seam(Corner c) { edges_ &= static_cast<std::uint16_t>(~(64u << (c & 3))); }

  /// Of a face that vanishes: its half-edges are neither queued nor lines any more.
  void clear_edges() { edges_ = 0; }

 private:
  static std::uint16_t bit_of(Corner c) { return static_cast<std::uint16_t>(1u << (c & 3)); }

  std::uint16_t edges_ = 0;  // three bits for queued half-edges, three for features, three for seams
};

using CornerTable = CornerTableT<FaceNotes>;

}  // namespace whittle::mq
