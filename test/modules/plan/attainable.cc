#include "whittle/plan/attainable.hh"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/surface/Surface.hh"

using namespace whittle;

namespace {

Attainable attainable_of(const IndexedMesh& mesh, const TargetCount& target,
                         const std::vector<std::uint8_t>& flags = {}, const std::vector<bool>& goes = {}) {
  return attainable(mesh, pieces_of(mesh), goes, flags, kLocked, target);
}

/// Locks the first vertices.
std::vector<std::uint8_t> first_locked(const IndexedMesh& mesh, std::size_t n) {
  std::vector<std::uint8_t> flags(mesh.points.size(), 0);
  std::fill_n(flags.begin(), n, kLocked);
  return flags;
}

}  // namespace

TEST_CASE("a target stays as it is where nothing is held") {
  const IndexedMesh torus = meshes::torus(48, 28);  // 1,344 vertices, 2,688 faces
  for (const std::size_t faces : {1, 4, 100, 2000, 2688, 9999}) {
    const Attainable found = attainable_of(torus, {faces, 0});
    CHECK_FALSE(found.is_higher);
    CHECK(found.target.faces == faces);
    CHECK(found.target.vertices == 0);
  }
  CHECK(attainable_of(torus, {100, 0}).pieces == 1);
  CHECK_FALSE(attainable_of(torus, {0, 0}).is_higher);
  CHECK_FALSE(attainable_of(IndexedMesh(), {10, 0}).is_higher);
}

TEST_CASE("small pieces raise a target by their last four faces each") {
  const IndexedMesh mesh = meshes::dusty_torus(100);  // 2,688 + 800 faces
  // A tenth: 348 faces. Each octahedron's share is 0.8 of a face, so all 100 hold 400.
  const Attainable found = attainable_of(mesh, {348, 0});
  CHECK(found.is_higher);
  CHECK(found.pieces == 101);
  CHECK(found.small == 100);
  CHECK(found.minimum == 400);
  CHECK(found.target.faces == static_cast<std::size_t>(std::ceil(400 + (3488 - 400) * 348.0 / 3488)));
  CHECK_FALSE(attainable_of(mesh, {348, 0}, {}, std::vector<bool>(101, false)).target.faces == 348);

  std::vector<bool> goes(101, true);
  goes[0] = false;
  CHECK_FALSE(attainable_of(mesh, {348, 0}, {}, goes).is_higher);
  CHECK(attainable_of(mesh, {348, 0}, {}, goes).pieces == 1);
}

TEST_CASE("a target rises only where the rest would have less than half of its share") {
  // 10 octahedra hold 40 faces of 2,768. At a target of T the rest has T - 40, and its share is 2728 T / 2768.
  const IndexedMesh mesh = meshes::dusty_torus(10);
  CHECK(attainable_of(mesh, {78, 0}).is_higher);        // 38 < 38.4
  CHECK_FALSE(attainable_of(mesh, {80, 0}).is_higher);  // 40 > 39.4
}

TEST_CASE("a locked vertex holds two faces, on the boundary one") {
  const IndexedMesh torus = meshes::torus(48, 28);
  CHECK(attainable_of(torus, {300, 0}, first_locked(torus, 20)).minimum == 40);
  const Attainable found = attainable_of(torus, {300, 0}, first_locked(torus, 672));
  CHECK(found.held == 672);
  CHECK(found.minimum == 1344);
  CHECK(found.target.faces == 1344 + 150);

  const IndexedMesh grid = meshes::flat_grid(11);  // 200 faces, the first row of 11 vertices on the boundary
  CHECK(attainable_of(grid, {50, 0}, first_locked(grid, 11)).minimum == 11);
  CHECK(attainable_of(grid, {50, 0}, first_locked(grid, 22)).minimum == 11 + 2 * 9 + 2);
  CHECK(attainable_of(grid, {50, 0}, std::vector<std::uint8_t>(121, kSeam)).held ==
        0);  // holds other planners only
}

TEST_CASE("a target of vertices rises as one of faces does, isolated ones included") {
  const IndexedMesh mesh = meshes::together({meshes::torus(48, 28), meshes::isolated_points(56)});
  const Attainable found = attainable_of(mesh, {0, 56 + 134}, first_locked(mesh, 672));
  CHECK(found.is_higher);
  CHECK(found.target.faces == 0);
  CHECK(found.target.vertices == 56 + 672 + 67);
  CHECK_FALSE(attainable_of(mesh, {0, 56 + 900}, first_locked(mesh, 100)).is_higher);
  // Either count will do: with both, the nearer one decides.
  CHECK_FALSE(attainable_of(mesh, {2600, 60}, first_locked(mesh, 672)).is_higher);
}

TEST_CASE("charts that keep a face raise a target by one face each where their share is less") {
  const IndexedMesh torus = meshes::torus(48, 28);  // 2,688 faces
  std::vector<ChartSize> kept(336, {0, 8});
  const auto found = [&](std::size_t faces) {
    return attainable(torus, pieces_of(torus), {}, {}, kLocked, {faces, 0}, kept);
  };
  const Attainable low = found(200);  // 0.6 of a face for each chart
  CHECK(low.is_higher);
  CHECK(low.charts == 336);
  CHECK(low.minimum == 336);
  CHECK(low.target.faces == static_cast<std::size_t>(std::ceil(336 + (2688 - 336) * 200.0 / 2688)));
  CHECK_FALSE(found(336).is_higher);  // a face for each
  CHECK(found(336).charts == 0);
  kept.resize(20);
  CHECK(found(200).charts == 20);
  CHECK_FALSE(found(200).is_higher);
}
