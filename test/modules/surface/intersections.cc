#include "whittle/surface/intersections.hh"

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/surface/errors.hh"

using namespace whittle;

namespace {

IndexedMesh soup(std::size_t n_faces, double size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  const auto vector = [&] { return meshes::Point(number(random), number(random), number(random)); };
  IndexedMesh mesh;
  for (std::uint32_t f = 0; f < n_faces; ++f) {
    const meshes::Point middle = vector();
    for (int k = 0; k < 3; ++k) mesh.points.emplace_back(middle + size * vector());
    mesh.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    if (f % 3 == 2) mesh.triangles.back()[0] = 3 * f - 1;  // some share vertices
  }
  return mesh;
}

std::vector<FacePair> one_by_one(const IndexedMesh& mesh) {
  std::vector<FacePair> pairs;
  const auto place = [&](std::uint32_t v) { return mesh.points[v]; };
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::uint32_t g = f + 1; g < mesh.triangles.size(); ++g)
      if (detail::faces_intersect(mesh.triangles[f], mesh.triangles[g], place)) pairs.push_back({f, g});
  return pairs;
}

}  // namespace

TEST_CASE("intersections: none in a clean mesh, all in a soup") {
  CHECK(intersections(IndexedMesh{}).pairs.empty());
  CHECK(intersections(meshes::torus(20, 9)).pairs.empty());
  CHECK(intersections(meshes::flat_grid(12)).pairs.empty());
  for (const std::size_t n : {1u, 3u, 4u, 5u, 8u, 9u, 300u}) {
    const IndexedMesh mesh = soup(n, n < 10 ? 2 : 0.3, static_cast<std::uint32_t>(n));
    const Intersections found = intersections(mesh);
    CHECK(found.complete);
    CHECK(found.pairs == one_by_one(mesh));
    if (n == 300) CHECK(found.pairs.size() > 200);
  }
}

TEST_CASE("intersections: the same for any number of threads, up to a number of pairs") {
  const IndexedMesh mesh = soup(5000, 0.04, 4);
  const Intersections all = intersections(mesh, 1000000, 1);
  REQUIRE(all.complete);
  REQUIRE(all.pairs.size() > 1000);
  CHECK(intersections(mesh, 1000000, 3).pairs == all.pairs);
  CHECK(intersections(mesh, all.pairs.size(), 3).complete);
  for (const std::size_t most : {std::size_t{0}, all.pairs.size() - 1}) {
    const Intersections some = intersections(mesh, most, 1);
    CHECK_FALSE(some.complete);
    CHECK(some.pairs.size() == most);
    CHECK(intersections(mesh, most, 3).pairs == some.pairs);
  }
}

TEST_CASE("intersections: faces at one place") {
  IndexedMesh same;
  for (std::uint32_t f = 0; f < 30; ++f) {
    for (const auto& p : {meshes::Point(0, 0, 0), meshes::Point(1, 0, 0), meshes::Point(0, 1, 0)})
      same.points.push_back(p);
    same.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  CHECK(intersections(same).pairs.size() == 30 * 29 / 2);
  CHECK(intersections(same, 100).pairs.size() == 100);
  for (auto& p : same.points) p *= 1e308;
  CHECK(intersections(same).pairs.size() == 30 * 29 / 2);
}

TEST_CASE(
    "intersections: where more faces are near one another than are looked at, the answer is not complete") {
  const IndexedMesh mesh = soup(300, 0.3, 300);
  const auto place = [&](std::uint32_t v) { return mesh.points[v]; };
  detail::Crew crew(1);
  const auto found = [&](std::size_t most_looks) {
    return detail::find_intersections(mesh.triangles, place, 1000000, crew, most_looks);
  };
  CHECK_FALSE(found(100).complete);
  CHECK(found(100).pairs.size() < found(1000000).pairs.size());
  CHECK(found(1000000).complete);
}

TEST_CASE("intersections: floats, and what is refused") {
  IndexedMeshT<float> mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25f, 0.25f, -1}, {0.25f, 0.25f, 1}, {5, 5, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  CHECK(intersections(mesh).pairs == std::vector<FacePair>{{0, 1}});
  mesh.triangles[1][2] = 6;
  CHECK_THROWS_AS(intersections(mesh), InvalidMesh);
  mesh.triangles[1][2] = 5;
  mesh.points[5].x() = std::numeric_limits<float>::quiet_NaN();
  CHECK_THROWS_AS(intersections(mesh), InvalidMesh);
}
