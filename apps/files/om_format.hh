/// \file
/// The layout of OpenMesh's own format, OM: a header, then chunks, each with the values of one thing for all
/// vertices, faces or half-edges. Everything is little endian.
#pragma once

#include <cstddef>
#include <cstdint>

namespace whittle::files::om {

constexpr std::size_t header_bytes = 16;  // "OM", mesh type, version; counts of vertices, faces, edges
constexpr std::size_t chunk_header_bytes = 2;
constexpr std::size_t status_bytes = 4;
constexpr std::uint32_t deleted_bit = 1;

/// As the byte in the header. From 2.0 on faces are given by half-edges, before by vertices; from 2.1 on a
/// property names its type.
constexpr std::uint8_t version(unsigned major, unsigned minor) {
  return static_cast<std::uint8_t>(major << 5 | minor);
}
constexpr unsigned major_of(std::uint8_t version) {
  return version >> 5;
}
constexpr unsigned minor_of(std::uint8_t version) {
  return version & 0x1fU;
}

/// What has the values of a chunk.
enum class Entity : unsigned { vertex = 0, mesh = 1, face = 2, edge = 4, halfedge = 6, end = 7 };

enum class Type : unsigned {
  position = 0,
  normal = 1,
  texture = 2,
  status = 3,
  colour = 4,
  custom = 6,
  topology = 7
};

/// Sixteen bits that say what is in a chunk.
struct ChunkHeader {
  bool named = false;
  Entity entity = Entity::vertex;
  Type type = Type::position;
  bool is_signed = false;
  bool is_float = false;
  unsigned dimensions = 1;
  unsigned size =
      0;  ///< of a number: 1, 2, 4, 8 bytes of an integer or 4, 8, 16 bytes of a float for 0, 1, …

  static ChunkHeader unpack(std::uint16_t bits) {
    ChunkHeader header;
    header.named = (bits >> 1 & 1U) != 0;
    header.entity = static_cast<Entity>(bits >> 2 & 7U);
    header.type = static_cast<Type>(bits >> 5 & 15U);
    header.is_signed = (bits >> 9 & 1U) != 0;
    header.is_float = (bits >> 10 & 1U) != 0;
    header.dimensions = (bits >> 11 & 7U) + 1;
    header.size = bits >> 14 & 3U;
    return header;
  }

  std::uint16_t pack() const {
    return static_cast<std::uint16_t>((named ? 1U : 0U) << 1 | static_cast<unsigned>(entity) << 2 |
                                      static_cast<unsigned>(type) << 5 | (is_signed ? 1U : 0U) << 9 |
                                      (is_float ? 1U : 0U) << 10 | (dimensions - 1) << 11 | size << 14);
  }

  /// Bytes of one number. Topology is flagged as float and is not.
  std::size_t number_bytes() const {
    const bool real = is_float && type != Type::topology;
    return std::size_t{real ? 4U : 1U} << size;
  }
};

}  // namespace whittle::files::om
