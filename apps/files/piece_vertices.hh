/// \file
/// The vertices of a part of a glTF mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// One vertex for each vertex of the mesh and the values that its corners have there, as the faces come to them.
struct PieceVertices {
  std::vector<std::uint32_t> corners;  ///< one corner of each, 3 f + k
  std::vector<std::uint32_t> indices;  ///< three for each face
};

PieceVertices vertices_of(const IndexedMesh& mesh, const std::vector<std::uint32_t>& faces,
                          const std::vector<const attributes::Attribute*>& attributes);

std::vector<float> values_of(const IndexedMesh& mesh, const PieceVertices& vertices,
                             const attributes::Attribute& attribute);

/// The first `count` components of each value.
std::vector<float> narrowed(const std::vector<float>& values, std::size_t components, std::size_t count);

}  // namespace whittle::files
