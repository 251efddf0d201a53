/// \file
/// Which vertices are kept in place, as people say it: `boundary`, `feature:30`, `selection:FILE`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::recipe {

struct Lock {
  enum class What { boundary, feature, selection };
  What what = What::boundary;
  double degrees = 0;  ///< feature: of the angle between the normals of an edge's two faces
  std::string file;    ///< selection

  /// Adds kLocked or kFeature to the flags of the vertices that it means; makes room for all if there are
  /// none. \throw files::FileError  a selection that cannot be read
  /// \throw RecipeError  one that names no vertex of the mesh: file and line
  /// \param vertex_of  for each vertex of the file the mesh's, as MeshFile has it: a selection counts those of the file
  void apply(const IndexedMesh& mesh, const std::vector<std::uint32_t>& vertex_of,
             std::vector<std::uint8_t>& flags) const;
};

/// \throw RecipeError
Lock parse_lock(const std::string& text);

}  // namespace whittle::recipe
