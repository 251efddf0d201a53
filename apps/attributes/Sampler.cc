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
  add(nearest, measure::shares(measure::corners(mesh_, mesh_.triangles[nearest]), at));
}

void Sampler::add(std::uint32_t face, const std::array<double, 3>& shares) {
  std::array<double, 4> sum{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < in_.components; ++i)
      if (shares[k] != 0) sum[i] += shares[k] * static_cast<double>(in_.value(in_.at(mesh_, face, k))[i]);
  if (in_.kind == Kind::normal) {
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const std::size_t fallback = shares[0] != 0 ? 0 : shares[1] != 0 ? 1 : 2;
    if (!(length > 0)) return copy(in_.at(mesh_, face, fallback));
    for (double& x : sum) x /= length;
  }
  for (std::size_t i = 0; i < in_.components; ++i) out_.values.push_back(static_cast<float>(sum[i]));
}

Attribute Sampler::take(std::vector<IndexedMesh::Triangle> corners) {
  out_.corners = std::move(corners);
  return std::move(out_);
}

}  // namespace whittle::attributes
