/// \file
/// PLY files without an element of faces: strips and fans of triangles, and range images.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "files/Fault.hh"
#include "files/MeshBuilder.hh"

namespace whittle::files {

/// Adds the triangles of strips or fans that stand one behind the other, with -1 between. In a strip each second
/// triangle is turned round, so all face the same way; where a vertex is named twice, to go on elsewhere, a triangle is
/// left out and counted.
/// \param indices  as in the file
inline void add_ply_strip(const std::vector<std::int64_t>& indices, bool is_fan, std::size_t vertices,
                          MeshBuilder& builder) {
  std::vector<std::uint32_t> strip;
  const auto add = [&] {
    for (std::size_t i = 2; i < strip.size(); ++i) {
      const std::size_t turned = is_fan ? 0 : i % 2;
      builder.add_face({strip[is_fan ? 0 : i - 2 + turned], strip[i - 1 - turned], strip[i]});
    }
    strip.clear();
  };
  for (const std::int64_t index : indices) {
    constexpr std::int64_t restart = -1, unsigned_restart = 0xffffffff;
    if (index == restart || index == unsigned_restart)
      add();
    else
      strip.push_back(builder.index(index, vertices));
  }
  add();
}

/// The cells of a range image, in rows, each with a vertex or none.
class PlyGrid {
 public:
  PlyGrid(std::uint64_t columns, std::uint64_t rows, std::uint64_t cells) : columns_(columns) {
    if (columns == 0 || rows == 0) throw Fault("a range_grid without num_cols and num_rows in obj_info");
    if (cells / columns != rows || cells % columns != 0)
      throw Fault("the range_grid has " + std::to_string(cells) + " cells instead of " +
                  std::to_string(columns) + " by " + std::to_string(rows));
  }

  void add_cell(std::uint32_t vertex) { cells_.push_back(vertex); }

  /// Adds the triangles between neighbours, counterclockwise where columns go to the right and rows up, as Stanford's
  /// scanners had it: two between four vertices, along the shorter diagonal, and one between three.
  void add_faces(MeshBuilder& builder) const {
    for (std::size_t i = columns_; i < cells_.size(); ++i) {
      if (i % columns_ == 0) continue;
      const std::uint32_t square[] = {cells_[i - columns_ - 1], cells_[i - columns_], cells_[i],
                                      cells_[i - 1]};
      std::vector<std::uint32_t> corners;
      for (const std::uint32_t vertex : square)
        if (vertex != no_vertex) corners.push_back(vertex);
      if (corners.size() == 4) {
        const std::size_t k = is_second_shorter(square, builder.mesh()) ? 1 : 0;
        builder.add_face({square[k], square[k + 1], square[k + 2]});
        builder.add_face({square[k], square[k + 2], square[(k + 3) % 4]});
      } else if (corners.size() == 3) {
        builder.add_face(corners);
      }
    }
  }

 private:
  static bool is_second_shorter(const std::uint32_t* square, const IndexedMesh& mesh) {
    const auto squared = [&](std::size_t i, std::size_t k) {
      return (mesh.points[square[i]] - mesh.points[square[k]]).squaredNorm();
    };
    return squared(1, 3) < squared(0, 2);
  }

  std::size_t columns_;
  std::vector<std::uint32_t> cells_;
};

}  // namespace whittle::files
