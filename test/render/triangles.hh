/// \file
/// Meshes of one or two triangles whose pictures are known.
#pragma once

#include "whittle/surface/IndexedMesh.hh"

namespace whittle {

/// Right-angled, facing the eye of a default camera. In a picture of 16 by 16 pixels, its edges run between
/// pixel centres: it covers column x and row y, counted from the lower left, where x >= 4, y >= 4 and x + y
/// <= 15.
inline IndexedMesh corner_triangle() {
  IndexedMesh mesh;
  mesh.points = {{-0.5, -0.5, 0}, {0.5625, -0.5, 0}, {-0.5, 0.5625, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Two triangles that cover the whole picture at depths `first` and `second`, drawn in this order. The first
/// one turns its front to the eye, the second its back.
inline IndexedMesh front_then_back(double first, double second) {
  IndexedMesh mesh;
  mesh.points = {{-1, -1, first},  {3, -1, first},  {-1, 3, first},
                 {-1, -1, second}, {3, -1, second}, {-1, 3, second}};
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
  return mesh;
}

}  // namespace whittle
