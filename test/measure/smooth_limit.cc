#include "measure/smooth_limit.hh"

#include <cmath>

#include "catch.hh"
#include "measure/Distance.hh"
#include "meshes.hh"
#include "whittle/bulk.hh"
#include "whittle/planners/MemorylessQuadric.hh"

using namespace whittle;
using namespace whittle::measure;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// A sphere of radius 1 in n rings between its poles, stretched by these factors.
IndexedMesh ellipsoid(std::uint32_t n, const Eigen::Vector3d& factors) {
  IndexedMesh mesh;
  const std::uint32_t around = 2 * n;
  const auto add = [&](double theta, double phi) {
    const Eigen::Vector3d at(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
    mesh.points.push_back(at.cwiseProduct(factors));
  };
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return ring * around + i % around; };
  for (std::uint32_t ring = 0; ring < n; ++ring)
    for (std::uint32_t i = 0; i < around; ++i) add((ring + 1) * kPi / (n + 1), i * 2 * kPi / around);
  const auto north = static_cast<std::uint32_t>(mesh.points.size()), south = north + 1;
  add(0, 0);
  add(kPi, 0);
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({north, at(0, i), at(0, i + 1)});
    mesh.triangles.push_back({south, at(n - 1, i + 1), at(n - 1, i)});
    for (std::uint32_t ring = 0; ring + 1 < n; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  return mesh;
}

/// The limit for x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1 by the midpoint rule over the angles: with h^2 the sum of
/// x^2 / a^4 and so on, K = 1 / (a b c h^2)^2, and the area's element is a b c h sin(theta).
double ellipsoid_limit(const Eigen::Vector3d& factors) {
  constexpr int kSteps = 800;
  const double volume = factors.prod();
  double integral = 0, area = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < 2 * kSteps; ++j) {
      const double theta = (i + 0.5) * kPi / kSteps, phi = (j + 0.5) * kPi / kSteps;
      const Eigen::Vector3d at(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
      const double h2 = at.cwiseQuotient(factors).squaredNorm();
      const double element = volume * std::sqrt(h2) * std::sin(theta) * (kPi / kSteps) * (kPi / kSteps);
      area += element;
      integral += std::cbrt(1 / (volume * h2 * volume * h2)) * element;
    }
  return std::pow(integral, 1.5) / std::sqrt(180 * area);
}

}  // namespace

TEST_CASE("smooth limit: of a sphere and of ellipsoids it is what the formula says") {
  CHECK(ellipsoid_limit({1, 1, 1}) == Approx(4 * kPi / std::sqrt(180.0)).epsilon(1e-5));
  for (const Eigen::Vector3d& factors : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 1, 0.5)}) {
    const double limit = ellipsoid_limit(factors);
    const double coarse = smooth_limit(ellipsoid(16, factors)), fine = smooth_limit(ellipsoid(48, factors));
    CHECK(std::abs(fine / limit - 1) < 0.01);
    CHECK(std::abs(fine / limit - 1) < std::abs(coarse / limit - 1));
  }
}

TEST_CASE("smooth limit: it grows with the size, and is 0 for what is flat") {
  const IndexedMesh sphere = ellipsoid(16, {1, 1, 1});
  IndexedMesh large = sphere;
  for (auto& p : large.points) p = 3 * p + Eigen::Vector3d(1, 2, 3);
  CHECK(smooth_limit(large) == Approx(3 * smooth_limit(sphere)));
  CHECK(smooth_limit(grid(5)) == 0);
  CHECK(smooth_limit(IndexedMesh()) == 0);
}

TEST_CASE("smooth limit: a saddle counts four fifths of a bowl of the same curvature") {
  const auto bent = [](double sign) {
    IndexedMesh mesh = grid(40);
    for (auto& p : mesh.points) p.z() = 0.001 * (std::pow(p.x() - 20, 2) + sign * std::pow(p.y() - 20, 2));
    return mesh;
  };
  CHECK(smooth_limit(bent(-1)) / smooth_limit(bent(1)) == Approx(std::sqrt(0.8)).epsilon(0.01));
}

TEST_CASE("smooth limit: mq stays above it, and not far") {
  const IndexedMesh mesh = ellipsoid(64, {2, 1, 0.5});
  MemorylessQuadric mq;
  mq.target_faces = 1000;
  const auto result = bulk(mq, mesh).mesh;
  const double limit = smooth_limit(mesh) / static_cast<double>(result.triangles.size());
  const double rms = distance(mesh, result, {50000, 0}).forward.rms;
  CHECK(rms > limit);
  CHECK(rms < 1.5 * limit);
}
