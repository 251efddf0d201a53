/// \file
/// Where a run stops.
#pragma once

#include <cstddef>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::recipe {

/// A target as counts: stop when the mesh has no more than this; 0: no such count.
struct Floor {
  std::size_t faces = 0, vertices = 0;

  bool any() const { return faces > 0 || vertices > 0; }
  bool reached(std::size_t n_faces, std::size_t n_vertices) const {
    return (faces > 0 && n_faces <= faces) || (vertices > 0 && n_vertices <= vertices);
  }
  bool reached(const IndexedMesh& mesh) const { return reached(mesh.triangles.size(), mesh.points.size()); }
};

}  // namespace whittle::recipe
