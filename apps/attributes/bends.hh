/// \file
/// How far a surface and what lies on it are from linear.
#pragma once

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

/// What nine tenths of the inner edges do not exceed, each counted with the area of its two faces; edges on a seam of
/// the attribute are left out, and of many edges some 20,000 are looked at. Both grow with the square of an edge's
/// length, so their ratio tells how much a decimation to any number of faces would spend on values instead of on
/// shape. A tenth may be borders between flat colours, or a line at which a texture is mirrored.
struct Bends {
  double shape = 0;  ///< of the one face's tip from the plane of the other, model units
  double value = 0;  ///< of its value from what the other face's values go on as
};

/// \pre the attribute fits the mesh
Bends bends(const IndexedMesh& mesh, const Attribute& attribute);

}  // namespace whittle::attributes
