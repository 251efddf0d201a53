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

/// For each vertex `count` values times their weights; not a number where the corners of a vertex disagree.
struct WeightedValues {
  std::vector<float> values;
  std::size_t count = 0;
};
/// \pre the attributes fit the mesh
WeightedValues weighted_values(const IndexedMesh& mesh, const Attributes& attributes,
                               const ValueWeights& weights);

}  // namespace whittle::attributes
