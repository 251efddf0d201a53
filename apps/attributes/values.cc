#include "attributes/values.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "attributes/bends.hh"

namespace whittle::attributes {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu, kSeveral = 0xfffffffeu;

/// Which value each vertex has; kNone where it is in no face.
std::vector<std::uint32_t> single_values(const IndexedMesh& mesh, const Attribute& attribute) {
  std::vector<std::uint32_t> single(mesh.points.size(), kNone);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& known = single[mesh.triangles[f][k]];
      const std::uint32_t value = attribute.at(mesh, f, k);
      if (known == kNone) known = value;
      if (known != value) known = kSeveral;
    }
  return single;
}

/// A weight, less where values bend more than the shape: at most `most` of how far that does, but a tenth at least.
double limited(double weight, const Bends& bends, double most) {
  constexpr double kLeast = 0.1;
  if (!(weight * bends.value > most * bends.shape)) return weight;
  return weight * std::max(kLeast, most * bends.shape / (weight * bends.value));
}

}  // namespace

double weight_of(Kind kind, const ValueWeights& weights) {
  switch (kind) {
    case Kind::normal:
      return weights.normals;
    case Kind::colour:
      return weights.colours;
    case Kind::texture:
      return weights.texture;
    default:
      return 0;
  }
}

ValueWeights default_weights(const IndexedMesh& mesh, const Attributes& attributes) {
  double area = 0;
  std::size_t components = 0;
  const auto cross = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return (b - a).cross(c - a).norm();
  };
  for (const auto& [a, b, c] : mesh.triangles)
    area += cross(mesh.points[a], mesh.points[b], mesh.points[c]) / 2;
  ValueWeights weights;
  for (const Attribute& attribute : attributes) {
    if (attribute.kind != Kind::colour && attribute.kind != Kind::texture) continue;
    components += attribute.components;
    if (attribute.kind == Kind::colour) {
      constexpr double kMost = 1;
      weights.colours = limited(0.003 * std::sqrt(area), bends(mesh, attribute), kMost);
      continue;
    }
    constexpr double kMost = 0.5;
    const auto place = [&](std::size_t face, std::size_t corner) {
      const float* uv = attribute.value(attribute.at(mesh, face, corner));
      return Eigen::Vector3d(uv[0], uv[1], 0);
    };
    double texture_area = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
      texture_area += cross(place(f, 0), place(f, 1), place(f, 2)) / 2;
    if (texture_area > 0)
      weights.texture = limited(0.1 * std::sqrt(area / texture_area), bends(mesh, attribute), kMost);
  }
  const bool is_sound = std::isfinite(weights.colours) && std::isfinite(weights.texture);
  return is_sound && components <= SurfaceExtras::kMostValues ? weights : ValueWeights();
}

WeightedValues weighted_values(const IndexedMesh& mesh, const Attributes& attributes,
                               const ValueWeights& weights) {
  WeightedValues out;
  for (const Attribute& attribute : attributes)
    if (weight_of(attribute.kind, weights) > 0) out.count += attribute.components;
  out.values.resize(out.count * mesh.points.size());
  std::size_t first = 0;
  for (const Attribute& attribute : attributes) {
    const double weight = weight_of(attribute.kind, weights);
    if (!(weight > 0)) continue;
    const std::vector<std::uint32_t> single = single_values(mesh, attribute);
    for (std::size_t v = 0; v < single.size(); ++v)
      for (std::size_t i = 0; i < attribute.components; ++i)
        out.values[out.count * v + first + i] =
            single[v] == kNone || single[v] == kSeveral
                ? std::nanf("")
                : static_cast<float>(weight * static_cast<double>(attribute.value(single[v])[i]));
    first += attribute.components;
  }
  return out;
}

}  // namespace whittle::attributes
