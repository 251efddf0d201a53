#include "fidelity/NormalDeviation.hh"

#include <cmath>

#include "catch.hh"
#include "experiment/GeneratedMesh.hh"
#include "whittle/surface/errors.hh"

using namespace whittle;

namespace {

/// A right-angled triangle in the plane z = 0, and the same with its far corner lifted.
IndexedMesh triangle(double lift) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, lift}}, {{0, 1, 2}}};
}

}  // namespace

TEST_CASE("a mesh does not deviate from itself") {
  const auto mesh = bench::generated_mesh(6);
  const auto d = bench::normal_deviation(mesh, mesh);
  CHECK(d.mean_degrees == Approx(0).margin(1e-9));
  CHECK(d.max_degrees == Approx(0).margin(1e-9));
  for (const double distance : bench::distances_to(mesh, mesh)) CHECK(distance == Approx(0).margin(1e-12));
}

TEST_CASE("a tilted face deviates by its tilt") {
  const auto d = bench::normal_deviation(triangle(0), triangle(1));
  CHECK(d.mean_degrees == Approx(45));
  CHECK(d.max_degrees == Approx(45));
}

TEST_CASE("a face turned over deviates by 180 degrees") {
  IndexedMesh turned = triangle(0);
  turned.triangles = {{0, 2, 1}};
  CHECK(bench::normal_deviation(triangle(0), turned).max_degrees == Approx(180));
}

TEST_CASE("quality is 1 for an equilateral triangle and falls as it grows thin") {
  CHECK(bench::triangle_quality({{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}, {{0, 1, 2}}}).mean ==
        Approx(1));
  CHECK(bench::triangle_quality(triangle(0)).mean == Approx(std::sqrt(3.0) / 2));
  CHECK(bench::triangle_quality({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}).mean ==
        Approx(0).margin(1e-12));
  CHECK(bench::triangle_quality({}).mean == 0);
}

TEST_CASE("the fifth percentile of quality is undercut by one face in twenty") {
  IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {2, 0, 0}}, {}};
  for (int i = 0; i < 19; ++i) mesh.triangles.push_back({0, 1, 2});
  mesh.triangles.push_back({0, 1, 3});
  CHECK(bench::triangle_quality(mesh).p05 == Approx(1));
  mesh.triangles.push_back({0, 1, 3});
  CHECK(bench::triangle_quality(mesh).p05 == Approx(0).margin(1e-12));
}

TEST_CASE("the deviation's distances are those of the original's points") {
  const auto distances = bench::distances_to(triangle(0.25), triangle(0));
  REQUIRE(distances.size() == 3);
  CHECK(distances[0] == Approx(0).margin(1e-12));
  CHECK(distances[2] == Approx(0.25));
}

TEST_CASE("the normal deviation refuses a mesh without surface") {
  CHECK_THROWS_AS(bench::normal_deviation(triangle(0), {}), InvalidMesh);
  CHECK_THROWS_AS(bench::distances_to(triangle(0), {}), InvalidMesh);
}
