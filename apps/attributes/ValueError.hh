/// \file
/// How far normals and colours have changed on a surface.
#pragma once

#include <cstddef>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

/// Differences of values at samples of the original and at the nearest places of the simplified surface: the length of the
/// difference of two colours, as they are counted from 0 to 1 (white differs from black by the root of 3), or of two
/// normals.
struct ValueError {
  double rms = 0, max = 0;  ///< over the samples
};

/// \param before, after  an attribute that fits the meshes
/// \param samples  on the original, spread evenly by area; positive
/// \throw InvalidMesh  one of the meshes has no face of positive area.
ValueError value_error(const IndexedMesh& original, const Attribute& before, const IndexedMesh& simplified,
                       const Attribute& after, std::size_t samples);

}  // namespace whittle::attributes
