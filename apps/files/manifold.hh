/// \file
/// Finding and repairing what is not manifold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "files/MeshFile.hh"
#include "measure/sides.hh"

namespace whittle::files {

/// Both with the meaning that `whittle info` gives the words.
struct NonManifold {
  std::size_t edges = 0;
  std::size_t vertices = 0;
};

/// \param sides  of all the mesh's faces, by edge
/// \{
NonManifold count_nonmanifold(const IndexedMesh& mesh, const std::vector<measure::Side>& sides);

/// The vertices whose faces are two fans or more that share no edge, ascending.
std::vector<std::uint32_t> vertices_of_several_fans(const IndexedMesh& mesh,
                                                    const std::vector<measure::Side>& sides);

/// For each face the first one on the same three vertices, whichever way round: itself, where none is before it.
std::vector<std::uint32_t> first_alike(const std::vector<IndexedMesh::Triangle>& triangles,
                                       const std::vector<measure::Side>& sides);
/// \}

/// Turns faces until neighbours agree wherever that is possible: in each connected piece the fewer.
/// \return how many were turned
std::size_t orient(MeshFile& file);

/// Copies vertices until every edge has one face or two that agree, and the faces of every vertex are one
/// fan. At an edge the first face that runs along it one way stays joined with the first that runs the other
/// way, the second with the second, and so on; one that is left over gets an edge of its own.
/// \return how many copies were made
std::size_t cut(MeshFile& file);

}  // namespace whittle::files
