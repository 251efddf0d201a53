/// \file
/// A mesh that came of another, and where its parts come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::recipe {

struct Decimated {
  IndexedMesh mesh;
  std::vector<std::uint32_t> vertex_map;   ///< for each input vertex the output vertex that it became
  std::vector<std::uint32_t> face_origin;  ///< for each output face the input face that it was
  std::size_t refused_faces = 0;           ///< input faces that OpenMesh could not take, left out

  /// The mesh as it is.
  static Decimated unchanged(const IndexedMesh& mesh);

  /// Decimated further: `next` came of this mesh, and this becomes what came of the input.
  void then(Decimated&& next);
};

/// Adds kSeam to the flags of the vertices that the wedges put on a seam; makes room for all flags.
void flag_seams(const IndexedMesh& mesh, SurfaceExtras& extras);

/// What is known of a mesh after a decimation: a vertex that others merged into has the flags of all of them and the
/// least of their tolerances; where there are wedges, kSeam if it is on a seam now.
/// \param before  the mesh that `decimated` came of
SurfaceExtras carried(const SurfaceExtras& extras, const IndexedMesh& before, const Decimated& decimated);

}  // namespace whittle::recipe
