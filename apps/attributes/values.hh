/// \file
/// Attributes as the numbers that a planner weighs against the shape.
#pragma once

#include <cstddef>
#include <vector>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::attributes {

/// What is weighed of a kind of attribute.
double weight_of(Kind kind, const ValueWeights& weights);

/// What colours and texture coordinates weigh where nobody says otherwise, in model units for a difference of 1:
/// colours 0.003 of the root of the area, texture coordinates 0.1 of the length that they are stretched by on average,
/// the root of the area over that in the texture. Less, down to a tenth, where the shape would pay too much for values
/// that bend more than it does (bends.hh): at nine tenths of the edges texture coordinates bend at most half as far as
/// the shape, colours as far. Measured (docs/modules/MemorylessQuadric.md); nothing where there are more than a
/// planner weighs.
ValueWeights default_weights(const IndexedMesh& mesh, const Attributes& attributes);

/// For each vertex `count` values times their weights; not a number where the corners of a vertex disagree.
struct WeightedValues {
  std::vector<float> values;
  std::size_t count = 0;
};
/// \pre the attributes fit the mesh
WeightedValues weighted_values(const IndexedMesh& mesh, const Attributes& attributes,
                               const ValueWeights& weights);

}  // namespace whittle::attributes
