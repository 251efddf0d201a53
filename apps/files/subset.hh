/// \file
/// Taking faces and vertices out of a mesh, with all that hangs on them.
#pragma once

#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Keeps the faces that are marked, in their order.
/// \return how many were removed
std::size_t keep_faces(MeshFile& file, const std::vector<bool>& keep);

/// Keeps the vertices that are marked, in their order.
/// \pre no face uses one that is not marked
/// \return how many were removed
std::size_t keep_vertices(MeshFile& file, const std::vector<bool>& keep);

/// Appends copies of vertices; the file's stay the originals.
void copy_vertices(MeshFile& file, const std::vector<std::uint32_t>& originals);

/// Some faces as a mesh of their own, with the values that they use.
struct FacesAlone {
  IndexedMesh mesh;
  attributes::Attributes attributes;
  std::vector<std::uint32_t> vertices;  ///< of the whole mesh, in their order
};
FacesAlone faces_alone(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                       const std::vector<std::uint32_t>& faces);

/// Takes out the faces that name a vertex that is not there, and counts them as broken.
void drop_faces_without_vertices(MeshFile& file);

/// Takes out the faces that name a vertex twice, and counts them.
void drop_degenerate_faces(MeshFile& file);

}  // namespace whittle::files
