/// \file
/// Attributes through a decimation.
#pragma once

#include <cstdint>
#include <vector>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

/// A mesh before and after a decimation, whatever did it.
struct Decimation {
  const IndexedMesh& before;
  const IndexedMesh& after;
  const std::vector<std::uint32_t>& vertex_map;   ///< for each vertex before, the vertex that it became
  const std::vector<std::uint32_t>& face_origin;  ///< for each face after, the face that it was
};

/// Which attributes tear when a vertex crosses a border of theirs, and so make seams. Texture coordinates always do; normals
/// and colours may have sharp edges, which a vertex may leave.
struct SeamKinds {
  bool normals = false, colours = false;
};

/// What the attributes are after a decimation.
///
/// A vertex that stands where it stood, and that nothing merged into, keeps its values. Any other gets the
/// values at the point nearest to it on the faces around the vertices that became it, interpolated linearly;
/// normals keep their length of one. Where corners differ that happens on each side for itself: a face of the result
/// looks at those faces that hang together with the one it was, without crossing a border. What makes seams takes on
/// one the value at the nearest point of the border, the same one on both sides.
/// \pre the attributes fit the mesh before.
Attributes transfer(const Attributes& attributes, const Decimation& decimation, const SeamKinds& kinds = {});

/// For each corner a number that tells apart what makes seams by its values, of all sets together: wedges as
/// SurfaceExtras has them. Empty where there is nothing of it at corners, and no area.
/// \param areas  for each face a number; between faces of different ones there is a seam. Empty: all are of one
std::vector<IndexedMesh::Triangle> seam_wedges(const Attributes& attributes, const SeamKinds& kinds = {},
                                               const std::vector<std::uint32_t>& areas = {});

/// For each corner a number that tells apart the sets of values that the corners of a vertex have: two
/// corners of one vertex have the same number where all attributes agree, and the parts of their faces. Empty where no
/// attribute is of corners and there are no parts.
/// \param parts  for each face the part that it is of, or empty
std::vector<IndexedMesh::Triangle> wedges(const IndexedMesh& mesh, const Attributes& attributes,
                                          const std::vector<std::uint32_t>& parts = {});

/// The attributes after edge flips, which leave the vertices but give each corner a wedge that was another's.
/// \param before, after  wedges of each corner before and after the flips.
Attributes rewedged(const Attributes& attributes, const std::vector<IndexedMesh::Triangle>& before,
                    const std::vector<IndexedMesh::Triangle>& after);

}  // namespace whittle::attributes
