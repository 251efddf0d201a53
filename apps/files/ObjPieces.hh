/// \file
/// OBJ, read in pieces by several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "files/MeshBuilder.hh"

namespace whittle::files {

/// What most OBJ files are made of: vertices of three coordinates, `vt`, `vn`, triangles whose corners count from 1, and
/// statements about the faces that follow. The numbers are those that ObjReader would read, bit for bit.
struct ObjLists {
  struct Statement {
    std::string_view keyword, rest;  ///< of usemtl, o, g, s or mtllib, and what stands behind it
    std::size_t faces = 0,
                triangles = 0;  ///< of the file before it; faces that name a vertex twice are no triangles
  };

  std::vector<IndexedMesh::Point> points;
  std::vector<float> texture, normals;           ///< two, and three, for each
  std::vector<IndexedMesh::Triangle> triangles;  ///< in range
  std::vector<IndexedMesh::Triangle> texture_of,
      normal_of;  ///< in range or no_value; none: no face names any
  std::vector<Statement> statements;
  std::size_t faces = 0;  ///< triangles, and faces that name a vertex twice
};

/// \return false: something else is in the file, or something is wrong with it; the lists are of no use then
bool read_obj_in_pieces(std::string_view bytes, ObjLists& lists);

}  // namespace whittle::files
