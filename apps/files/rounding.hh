/// \file
/// What 32-bit floats do to coordinates far from the origin.
#pragma once

#include "files/MeshFile.hh"

namespace whittle::files {

/// How far a point moves at most when its coordinates become 32-bit floats. Model units.
/// \param origin  from which the coordinates are counted
double largest_rounding(const IndexedMesh& mesh,
                        const IndexedMesh::Point& origin = IndexedMesh::Point::Zero());

/// The length that rounding may come to before anybody needs to know: a hundredth of the shortest edge that has a length;
/// where there are no edges, a millionth of the bounding box's diagonal. Model units.
double tolerable_rounding(const IndexedMesh& mesh);

/// From where to count so that floats hold the mesh: zero where its coordinates are within what is tolerable as they are,
/// else a place near its middle, of few binary digits, so that decimal text holds it exactly.
IndexedMesh::Point origin_for_floats(const IndexedMesh& mesh);

/// Notes by how much coordinates are rounded, where it is more than tolerable.
void note_rounding(const IndexedMesh& mesh, WriteReport& report,
                   const IndexedMesh::Point& origin = IndexedMesh::Point::Zero());

}  // namespace whittle::files
