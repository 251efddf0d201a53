/// \file
/// The header of a PLY file: what stands in the body, in which order and how it is encoded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/TextReader.hh"

namespace whittle::files {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of one value in a binary body.
std::size_t ply_size(PlyType type);

bool ply_is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::int8;  ///< of a list: of its entries
  bool is_list = false;
  PlyType length_type = PlyType::uint8;  ///< lists only
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> images;                ///< that comments name, as MeshLab writes them
  std::uint64_t grid_columns = 0, grid_rows = 0;  ///< obj_info num_cols, num_rows: of a range image

  /// The element of this name, null if there is none.
  const PlyElement* find(const std::string& name) const;
};

/// Leaves `in` on the line `end_header`.
/// \throw Fault
PlyHeader read_ply_header(TextReader& in);

}  // namespace whittle::files
