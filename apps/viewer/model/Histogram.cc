#include "model/Histogram.hh"

#include <algorithm>
#include <cmath>

#include "measure/triangle.hh"

namespace whittle::viewer {
namespace {

constexpr std::size_t kBins = 48;

}  // namespace

Histogram histogram(const std::vector<float>& values, double low, double high, std::size_t n_bins) {
  Histogram out{low, high, std::vector<std::size_t>(n_bins, 0), 0, 0};
  const double scale = static_cast<double>(n_bins) / (high - low);
  for (const float value : values) {
    const double x = double(value);
    if (x < low)
      ++out.below;
    else if (!(x <= high))
      ++out.above;
    else
      ++out.bins[std::min(n_bins - 1, static_cast<std::size_t>((x - low) * scale))];
  }
  return out;
}

double quantile(std::vector<float> values, double part) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1));
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), nth, values.end());
  return double(*nth);
}

std::vector<float> qualities(const IndexedMesh& mesh) {
  std::vector<float> values;
  values.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    const measure::Corners t = measure::corners(mesh, triangle);
    const double squares = (t.b - t.a).squaredNorm() + (t.c - t.b).squaredNorm() + (t.a - t.c).squaredNorm();
    values.push_back(static_cast<float>(squares > 0 ? 4 * std::sqrt(3.0) * t.area() / squares : 0));
  }
  return values;
}

std::vector<float> values_of(Quantity quantity, const IndexedMesh& mesh, const std::vector<Edge>& edges) {
  if (quantity == Quantity::quality) return qualities(mesh);
  std::vector<float> values;
  values.reserve(edges.size());
  for (const Edge& edge : edges) {
    if (quantity == Quantity::edge_length)
      values.push_back(edge.length);
    else if (edge.kind == EdgeKind::plain)
      values.push_back(edge.angle);
  }
  return values;
}

HistogramPair histograms(Quantity quantity, const std::vector<float>& original,
                         const std::vector<float>* result) {
  double high = quantity == Quantity::quality      ? 1
                : quantity == Quantity::face_angle ? 90
                                                   : quantile(original, 0.999);
  if (quantity == Quantity::edge_length && result) high = std::max(high, quantile(*result, 0.99));
  if (!(high > 0)) high = 1;
  return {histogram(original, 0, high, kBins),
          histogram(result ? *result : std::vector<float>{}, 0, high, kBins)};
}

const char* name(Quantity quantity) {
  return quantity == Quantity::edge_length  ? "Edge length"
         : quantity == Quantity::face_angle ? "Face angle"
                                            : "Triangle quality";
}

}  // namespace whittle::viewer
