/// \file
/// Texture atlases over any mesh.
#pragma once

#include <cstddef>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::speed {

/// Charts of up to so many faces that grow from faces drawn at random (the same on every run), each projected onto the
/// plane of its first face and as large as its cell of a square grid. Their borders are jagged and their scales
/// differ: harder than what unwrapping makes.
attributes::Attribute grown_atlas(const IndexedMesh& mesh, std::size_t faces_per_chart);

/// Charts of faces whose normals differ from that of the chart's first face by less than an angle, in degrees, each
/// projected onto the plane of that face, all in one scale and packed in rows: as programs unwrap. What remains as a
/// chart of a few faces joins a neighbour.
attributes::Attribute unwrapped_atlas(const IndexedMesh& mesh, double degrees);

/// Charts of connected faces that look along the same axis more than along another, one way, each projected along that
/// axis, all in one scale and packed in rows: a cube projection. What remains as a chart of a few faces joins a neighbour.
attributes::Attribute cubic_atlas(const IndexedMesh& mesh);

}  // namespace whittle::speed
