/// \file
/// How far a texture has slid on a surface.
#pragma once

#include <cstddef>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

/// Distances in the texture between samples of the original and the nearest places of the same charts on the
/// simplified surface, at a slit those on the same side of it.
struct TextureError {
  double rms = 0, max = 0;  ///< over the samples, in texels
  std::size_t samples = 0;  ///< without those of charts that have vanished
  std::size_t charts = 0;   ///< of the original
  std::size_t charts_left = 0;
};

struct TextureErrorOptions {
  double texels = 1024;          ///< across the texture, where u goes from 0 to 1
  double texels_high = 0;        ///< the same for v; 0: as many
  std::size_t samples = 200000;  ///< on the original, spread evenly by area
  unsigned threads = 0;          ///< 0: all cores; the result is the same for every number
};

/// Charts are what seams enclose in the original. A face of the simplified mesh is in the chart where its centre lies
/// in the texture; where charts overlap there, in the one of the face nearest to it in space.
/// \param before, after  texture coordinates that fit the meshes; any that counts v downwards is turned
/// \throw InvalidMesh       one of the meshes, or the original's texture, has no face of positive area.
/// \throw InvalidParameter  no samples, texels that are not positive or, high, negative.
TextureError texture_error(const IndexedMesh& original, const Attribute& before,
                           const IndexedMesh& simplified, const Attribute& after,
                           const TextureErrorOptions& options = {});

}  // namespace whittle::attributes
