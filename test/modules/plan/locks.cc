#include "whittle/plan/locks.hh"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

std::vector<std::uint32_t> features(const IndexedMesh& mesh, double degrees) {
  std::vector<std::uint8_t> flags(mesh.points.size(), 0);
  detail::lock_features(SurfaceT<double>(mesh), degrees, flags);
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < flags.size(); ++v)
    if (flags[v] == kFeature) out.push_back(v);
  return out;
}

using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("features are the ends of edges sharper than the angle, wherever a ring begins") {
  IndexedMesh roof = meshes::grid(5, [](std::uint32_t i, std::uint32_t) { return -std::abs(2.0 - i); });
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    CHECK(features(roof, 89) == Numbers{2, 7, 12, 17, 22});
    CHECK(features(roof, 91).empty());
    for (std::size_t i = roof.triangles.size(); i-- > 1;)
      std::swap(roof.triangles[i], roof.triangles[random() % i]);
  }
  CHECK(features(meshes::flat_grid(4), 0).empty());
}

TEST_CASE("a vertex without a ring is a feature by its neighbours' edges") {
  IndexedMesh roof = meshes::grid(5, [](std::uint32_t i, std::uint32_t) { return -std::abs(2.0 - i); });
  roof.points.insert(roof.points.end(), {{2, 2, 9}, {3, 2, 9}});
  roof.triangles.push_back({12, 26, 25});  // touches the ridge in 12
  CHECK(features(roof, 60) == Numbers{2, 7, 12, 17, 22});
}

TEST_CASE("the boundary that is locked is that of open edges") {
  std::vector<std::uint8_t> flags(9, kFeature);
  detail::lock_boundary(SurfaceT<double>(meshes::flat_grid(3)), flags);
  for (std::size_t v = 0; v < 9; ++v) CHECK(flags[v] == (v == 4 ? kFeature : kFeature | kLocked));
}

TEST_CASE("features are those of a search over all pairs of faces, however the faces are ordered") {
  IndexedMesh mesh = meshes::shaken(meshes::flat_grid(9), 0.25, 3);  // sharp edges here and there
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const SurfaceT<double> surface(mesh);
    std::vector<bool> expected(mesh.points.size(), false);
    for (std::uint32_t f = 0; f < surface.n_faces(); ++f)
      for (std::uint32_t g = 0; g < f; ++g) {
        std::vector<std::uint32_t> both;
        for (const std::uint32_t v : surface.triangle(f))
          for (const std::uint32_t w : surface.triangle(g))
            if (v == w) both.push_back(v);
        const Eigen::Vector3d a = surface.normal(f).normalized(), b = surface.normal(g).normalized();
        if (both.size() == 2 && a.dot(b) < std::cos(45 * meshes::kPi / 180))
          expected[both[0]] = expected[both[1]] = true;
      }
    Numbers numbers;
    for (std::uint32_t v = 0; v < expected.size(); ++v)
      if (expected[v]) numbers.push_back(v);
    REQUIRE(numbers.size() > 4);
    REQUIRE(numbers.size() < 60);
    CHECK(features(mesh, 45) == numbers);
    for (std::size_t i = mesh.triangles.size(); i-- > 1;)
      std::swap(mesh.triangles[i], mesh.triangles[random() % i]);
  }
}
