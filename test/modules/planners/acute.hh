/// \file
/// An acute triangle in a hexagon, for planners that look at the lengths of a triangle's edges.
#pragma once

#include "meshes.hh"

namespace meshes {

inline const Eigen::Vector3d kA(0, 0, 0), kB(0.25, 0, 0), kC(0.125, 0.375, 0);  // edges 0.25, 0.395, 0.395

inline IndexedMesh acute() {
  return triangle_in_hexagon(kA, kB, kC, 1);
}

}  // namespace meshes
