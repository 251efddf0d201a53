/// \file
/// How the sizes in a mesh are distributed.
#pragma once

#include <cstddef>
#include <vector>

#include "model/EdgeTable.hh"
#include "model/RecipeEdit.hh"

namespace whittle::viewer {

struct Histogram {
  double low = 0, high = 1;
  std::vector<std::size_t> bins;
  std::size_t below = 0, above = 0;  ///< values outside of [low, high]

  double bin_width() const { return (high - low) / static_cast<double>(bins.size()); }
};

/// \pre low < high, n_bins > 0
Histogram histogram(const std::vector<float>& values, double low, double high, std::size_t n_bins);

/// The value below which this part of the values lies; 0 of none.
/// \param part  in [0, 1]
double quantile(std::vector<float> values, double part);

/// The values of a quantity: edge lengths in model units, angles between the normals of neighbouring faces in
/// degrees, qualities of the triangles.
std::vector<float> values_of(Quantity quantity, const IndexedMesh& mesh, const std::vector<Edge>& edges);

/// 4√3·area / (a² + b² + c²): 1 equilateral, 0 degenerate. One for each triangle.
std::vector<float> qualities(const IndexedMesh& mesh);

/// The histograms of a quantity in the original and in the result, over one axis from 0.
struct HistogramPair {
  Histogram original, result;  ///< without a result all its bins are empty
};

/// \param result  null if there is none.
HistogramPair histograms(Quantity quantity, const std::vector<float>& original,
                         const std::vector<float>* result);

const char* name(Quantity quantity);
constexpr Quantity kQuantities[] = {Quantity::edge_length, Quantity::face_angle, Quantity::quality};

}  // namespace whittle::viewer
