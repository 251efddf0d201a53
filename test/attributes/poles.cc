#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "attributes/TextureError.hh"
#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "textured.hh"

using namespace whittle;
using attributes::Attribute;
using attributes::Attributes;
using attributes::texture_error;
using attributes::TextureError;
using fixture::mq_down_to;
using fixture::run_with;
using fixture::textured;
using meshes::kPi;

namespace {

/// A sphere of n by n / 2 fields with the poles at top and bottom.
IndexedMesh globe(std::uint32_t n) {
  IndexedMesh mesh;
  const std::uint32_t rows = n / 2;
  mesh.points.emplace_back(0, 0, 1);
  for (std::uint32_t j = 1; j < rows; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double across = 2 * kPi * i / n, down = kPi * j / rows;
      mesh.points.emplace_back(std::sin(down) * std::cos(across), std::sin(down) * std::sin(across),
                               std::cos(down));
    }
  const auto bottom = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(0, 0, -1);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n, last = bottom - n;
    mesh.triangles.push_back({0, 1 + i, 1 + next});
    mesh.triangles.push_back({bottom, last + next, last + i});
    for (std::uint32_t v = 1; v < last; v += n) {
      mesh.triangles.push_back({v + i, v + n + i, v + n + next});
      mesh.triangles.push_back({v + i, v + n + next, v + next});
    }
  }
  return mesh;
}

/// Longitude and latitude from 0 to 1, as every modelling program has it: at the poles each face has a longitude of its
/// own, and one meridian is a seam.
Attribute longitudes(const IndexedMesh& globe) {
  return textured(globe, [&](std::uint32_t f, const meshes::Point& p) {
    const auto longitude = [](const meshes::Point& q) { return std::atan2(q.y(), q.x()) / (2 * kPi) + 0.5; };
    const auto is_pole = [](const meshes::Point& q) { return std::hypot(q.x(), q.y()) < 1e-9; };
    double sum = 0, least = 1, most = 0, n = 0;
    for (const std::uint32_t v : globe.triangles[f]) {
      const meshes::Point& q = globe.points[v];
      if (is_pole(q)) continue;
      least = std::min(least, longitude(q));
      most = std::max(most, longitude(q));
      sum += longitude(q);
      ++n;
    }
    const bool wraps = most - least > 0.5;
    double u = is_pole(p) ? (wraps ? (sum + 1) / n : sum / n) : longitude(p);
    if (wraps && !is_pole(p) && u < 0.5) u += 1;
    return Eigen::Vector2d(u, std::acos(std::clamp(p.z(), -1.0, 1.0)) / kPi);
  });
}

}  // namespace

TEST_CASE("around the poles of a sphere, where each face has a coordinate of its own, vertices merge") {
  const IndexedMesh mesh = globe(64);
  const Attributes given{longitudes(mesh)};
  for (const char* spec : {"mq", "quadric"}) {
    CAPTURE(spec);
    const auto result = run_with(mesh, mq_down_to(400, spec), given);
    CHECK(result.mesh.triangles.size() <= 400);
    CHECK(measure::facts(result.mesh).boundary_edges == 0);
    CHECK(result.charts == 1);
    std::size_t at_poles = 0;
    for (const auto& t : result.mesh.triangles)
      at_poles += std::any_of(t.begin(), t.end(),
                              [&](std::uint32_t v) { return result.mesh.points[v].head<2>().norm() < 1e-3; });
    CHECK(at_poles <= 40);  // of 128
    const TextureError error = texture_error(mesh, given[0], result.mesh, result.attributes[0]);
    CHECK(error.rms < 20);
  }
}

TEST_CASE("all drivers agree around poles") {
  const IndexedMesh mesh = globe(48);
  const Attributes given{longitudes(mesh)};
  const auto bulk = run_with(mesh, mq_down_to(300), given);
  for (const auto driver : {whittle::recipe::Driver::sweep, whittle::recipe::Driver::decimater}) {
    auto recipe = mq_down_to(300);
    recipe.driver = driver;
    CHECK(meshes::canonical(run_with(mesh, recipe, given).mesh) == meshes::canonical(bulk.mesh));
  }
}

TEST_CASE("the texture error is that on the same side of a slit, wherever the slit runs now") {
  const IndexedMesh mesh = globe(32);
  const Attribute before = longitudes(mesh);
  // A turn by a thousandth around moves the slit over the sphere; the texture moves with it.
  IndexedMesh turned = mesh;
  const Eigen::AngleAxisd turn(2 * kPi / 1000, Eigen::Vector3d::UnitZ());
  for (auto& p : turned.points) p = turn * p;
  const TextureError error = texture_error(mesh, before, turned, before);
  CHECK(error.charts == 1);
  CHECK(error.rms == Approx(1.024).epsilon(0.05));
  CHECK(error.max < 30);  // around the poles; the other side would be 1,024 off
}
