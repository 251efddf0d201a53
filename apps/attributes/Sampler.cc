#include "attributes/Sampler.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "measure/triangle.hh"

namespace whittle::attributes {
Sampler::Sampler(const Attribute& attribute, const IndexedMesh& mesh) : in_(attribute), mesh_(mesh) {
  out_.kind = in_.kind;
  out_.name = in_.name;
  out_.components = in_.components;
  out_.bytes = in_.bytes;
  out_.downwards = in_.downwards;
}

void Sampler::copy(std::uint32_t value) {
  out_.values.insert(out_.values.end(), in_.value(value), in_.value(value) + in_.components);
}

void Sampler::interpolate(const Eigen::Vector3d& p, const std::vector<std::uint32_t>& faces) {
  double least = HUGE_VAL;
  std::uint32_t nearest = faces.front();
  Eigen::Vector3d at = p;
  for (const std::uint32_t f : faces) {
    const Eigen::Vector3d q = measure::closest_point(p, measure::corners(mesh_, mesh_.triangles[f]));
    const double distance = (q - p).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = f;
    at = q;
  }
  const auto share = measure::shares(measure::corners(mesh_, mesh_.triangles[nearest]), at);
  std::array<double, 4> sum{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < in_.components; ++i)
      sum[i] += share[k] * static_cast<double>(in_.value(in_.at(mesh_, nearest, k))[i]);
  add(sum, in_.at(mesh_, nearest, 0));
}

void Sampler::between(std::uint32_t from, std::uint32_t to, double share) {
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < in_.components; ++i)
    sum[i] =
        (1 - share) * static_cast<double>(in_.value(from)[i]) + share * static_cast<double>(in_.value(to)[i]);
  add(sum, from);
}

void Sampler::add(std::array<double, 4> value, std::uint32_t fallback) {
  if (in_.kind == Kind::normal) {
    const double length = std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
    if (!(length > 0)) return copy(fallback);
    for (double& x : value) x /= length;
  }
  for (std::size_t i = 0; i < in_.components; ++i) out_.values.push_back(static_cast<float>(value[i]));
}

Attribute Sampler::take(std::vector<IndexedMesh::Triangle> corners) {
  out_.corners = std::move(corners);
  return std::move(out_);
}

}  // namespace whittle::attributes
