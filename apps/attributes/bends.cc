#include "attributes/bends.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "measure/sides.hh"
#include "measure/triangle.hh"

namespace whittle::attributes {
namespace {

constexpr std::size_t kMostEdges = 20000;
constexpr double kPart = 0.9;

/// Figures with the areas that they stand for.
using Weighted = std::vector<std::pair<double, double>>;

/// The figure that a part of the area does not exceed.
double quantile(Weighted all) {
  if (all.empty()) return 0;
  std::sort(all.begin(), all.end());
  double area = 0, so_far = 0;
  for (const auto& entry : all) area += entry.second;
  for (const auto& entry : all) {
    so_far += entry.second;
    if (so_far >= kPart * area) return entry.first;
  }
  return all.back().first;
}

class Edges {
 public:
  Edges(const IndexedMesh& mesh, const Attribute& attribute) : mesh_(mesh), attribute_(attribute) {}

  Bends run() {
    const auto sides = measure::sides_by_edge(mesh_.triangles, mesh_.points.size(), measure::Faces::proper);
    const std::size_t step = 1 + sides.size() / 2 / kMostEdges;
    std::size_t edge = 0;
    measure::for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
      if (end - begin == 2 && edge++ % step == 0) add(begin[0].corner, begin[1].corner);
    });
    return {quantile(std::move(shape_)), quantile(std::move(value_))};
  }

 private:
  using Value = Eigen::Vector4d;

  Value value(std::uint32_t corner) const {
    Value out = Value::Zero();
    const float* from = attribute_.value(attribute_.at(mesh_, corner / 3, corner % 3));
    for (std::size_t i = 0; i < attribute_.components; ++i)
      out[static_cast<Eigen::Index>(i)] = static_cast<double>(from[i]);
    return out;
  }

  /// The two sides of an edge, by the corners where they start.
  void add(std::uint32_t one, std::uint32_t other) {
    using measure::next_corner;
    const bool is_seam = value(one) != value(next_corner(other)) || value(next_corner(one)) != value(other);
    const measure::Corners face = measure::corners(mesh_, mesh_.triangles[one / 3]);
    const std::uint32_t tip = measure::opposite_corner(other);
    const Eigen::Vector3d normal = face.normal(),
                          to_tip = mesh_.points[measure::vertex_of(mesh_.triangles, tip)] - face.a;
    if (is_seam || face.degenerate()) return;
    const double square = normal.squaredNorm(), b = (face.c - face.a).cross(normal).dot(to_tip) / square,
                 c = normal.cross(face.b - face.a).dot(to_tip) / square;
    const std::uint32_t first = one / 3 * 3;
    const Value goes_on = (1 - b - c) * value(first) + b * value(first + 1) + c * value(first + 2);
    const double area = face.area() + measure::corners(mesh_, mesh_.triangles[other / 3]).area();
    shape_.emplace_back(std::abs(to_tip.dot(normal)) / std::sqrt(square), area);
    value_.emplace_back((value(tip) - goes_on).norm(), area);
  }

  const IndexedMesh& mesh_;
  const Attribute& attribute_;
  Weighted shape_, value_;
};

}  // namespace

Bends bends(const IndexedMesh& mesh, const Attribute& attribute) {
  return Edges(mesh, attribute).run();
}

}  // namespace whittle::attributes
