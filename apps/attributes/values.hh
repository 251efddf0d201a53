/// \file
/// Attributes as the numbers that a planner weighs against the shape.
#pragma once

#include <cstddef>
#include <vector>

#include "attributes/Attribute.hh"
#include "whittle/IndexedMesh.hh"

namespace whittle::attributes {

/// As what length, in model units, a difference of 1 counts; 0: not at all. Of normals 1 is 60 degrees, of
/// colours from black to full.
struct ValueWeights {
  double normals = 0, colours = 0, texture = 0;
  double of(Kind kind) const;
  bool any() const { return normals > 0 || colours > 0 || texture > 0; }
};

/// For each vertex `count` values times their weights; not a number where the corners of a vertex disagree.
struct WeightedValues {
  std::vector<float> values;
  std::size_t count = 0;
};
/// \pre the attributes fit the mesh
WeightedValues weighted_values(const IndexedMesh& mesh, const Attributes& attributes,
                               const ValueWeights& weights);

}  // namespace whittle::attributes
