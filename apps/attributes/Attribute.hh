/// \file
/// What a file holds of a mesh besides its shape: normals, colours, texture coordinates, weights.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::attributes {

enum class Kind {
  normal,   ///< 3 components, unit length as far as the file keeps to it, zero where it gives none
  colour,   ///< 3 or 4 components, 0..1: red, green, blue, opacity
  texture,  ///< 2 components, as the file counts them; see `downwards`
  scalar,   ///< 1 component, of any meaning, told apart by its name
  vector,   ///< 1 to 4 components, of any meaning, told apart by their name; glTF's morph targets
  skin      ///< pairs of a joint's number and its weight, which is 0 where there is none
};

/// Values, and which of them each corner of a face has. A vertex whose corners have different values is on a
/// seam.
struct Attribute {
  Kind kind = Kind::scalar;
  std::string name;                            ///< as in the file: "quality"; of a scene all have one
  std::size_t components = 1;                  ///< of a value
  bool bytes = false;                          ///< colours only: the file has 0..255, so 8 bits say all
  bool downwards = false;                      ///< texture only: v grows downwards, as glTF counts it
  std::vector<float> values;                   ///< `components` for each
  std::vector<IndexedMesh::Triangle> corners;  ///< for each face its corners' values; empty: value i is
                                               ///< vertex i's, and there is one for each vertex
  bool names = false;                          ///< scalars and vectors that name something and do not blend

  std::size_t n_values() const { return values.size() / components; }
  const float* value(std::size_t i) const { return values.data() + components * i; }
  bool per_vertex() const { return corners.empty(); }

  /// The value at a corner of a face.
  std::uint32_t at(const IndexedMesh& mesh, std::size_t face, std::size_t corner) const {
    return per_vertex() ? mesh.triangles[face][corner] : corners[face][corner];
  }
};

using Attributes = std::vector<Attribute>;

/// "normals", "texture coordinates", "property 'quality'": for messages.
std::string to_string(const Attribute& attribute);

}  // namespace whittle::attributes
