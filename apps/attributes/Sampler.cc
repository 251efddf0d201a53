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
  out_.names = in_.names;
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

void Sampler::add_skin(std::uint32_t face, const std::array<double, 3>& shares) {
  std::vector<std::pair<float, double>> weights;  // by joint
  double all = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float* pairs = in_.value(in_.at(mesh_, face, k));
    for (std::size_t i = 0; i < in_.components; i += 2) {
      const double weight = shares[k] * static_cast<double>(pairs[i + 1]);
      if (!(weight > 0)) continue;
      all += weight;
      const auto same = std::find_if(weights.begin(), weights.end(),
                                     [&](const auto& other) { return other.first == pairs[i]; });
      if (same == weights.end())
        weights.emplace_back(pairs[i], weight);
      else
        same->second += weight;
    }
  }
  // The strongest stay, and make up for the others.
  std::stable_sort(weights.begin(), weights.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (weights.size() > in_.components / 2) weights.resize(in_.components / 2);
  double kept = 0;
  for (const auto& [joint, weight] : weights) kept += weight;
  for (const auto& [joint, weight] : weights) {
    out_.values.push_back(joint);
    out_.values.push_back(static_cast<float>(weight * all / kept));
  }
  out_.values.resize(out_.values.size() + in_.components - 2 * weights.size(), 0.0F);
}

void Sampler::add(std::uint32_t face, const std::array<double, 3>& shares) {
  if (in_.kind == Kind::skin) return add_skin(face, shares);
  if (in_.names)
    return copy(
        in_.at(mesh_, face,
               static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin())));
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
