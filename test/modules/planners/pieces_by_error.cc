#include "whittle/planners/pieces_by_error.hh"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/planners/PieceChoice.hh"

using namespace whittle;

namespace {

std::size_t n_gone(const std::vector<bool>& goes) {
  return static_cast<std::size_t>(std::count(goes.begin(), goes.end(), true));
}

std::vector<bool> choose(const IndexedMesh& mesh, std::size_t faces, const SurfaceExtras& extras = {},
                         std::size_t n_threads = 1) {
  return pieces_by_error(mesh, pieces_of(mesh), extras, {faces, 0}, n_threads);
}

}  // namespace

TEST_CASE("what a piece costs is the moment of its surface about its centroid") {
  // A square of side 2 about its middle: the integral of x^2 + y^2 is 8 / 3, and mq counts areas twice.
  IndexedMesh square;
  square.points = {{4, -1, 3}, {6, -1, 3}, {6, 1, 3}, {4, 1, 3}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const IndexedMesh mesh = meshes::together({square, meshes::placed(square, 10, {0, 0, 0})});
  const auto costs = detail::piece_costs(mesh, pieces_of(mesh), 1);
  REQUIRE(costs.size() == 2);
  CHECK(costs[0] == Approx(16.0 / 3));
  CHECK(costs[1] == Approx(1e4 * 16 / 3));
  CHECK(detail::piece_costs(mesh, pieces_of(mesh), 10)[1] == Approx(16.0 / 3));
}

TEST_CASE("the smallest pieces go first, and only as many as the target needs") {
  // The octahedra cannot lose a face without losing their shape, the flat grid can lose nearly all.
  std::vector<IndexedMesh> parts = {meshes::flat_grid(9)};  // 128 faces, 2 at least
  for (int i = 1; i <= 4; ++i)
    parts.push_back(meshes::placed(meshes::octahedron(), 0.3 * i, {20.0 + 4 * i, 0, 0}));
  const IndexedMesh mesh = meshes::together(parts);  // 160 faces
  CHECK(choose(mesh, 44) == std::vector<bool>{false, false, false, false, false});
  const auto some = choose(mesh, 12);
  CHECK_FALSE(some[0]);
  CHECK(some[1]);
  CHECK_FALSE(some[4]);
  CHECK(std::is_sorted(some.begin() + 1, some.end(), std::greater<>()));
}

TEST_CASE("the dearest piece always stays, and so does one with a locked vertex") {
  const IndexedMesh mesh = meshes::dusty_torus(20);
  CHECK(n_gone(choose(mesh, 1)) == 20);
  CHECK_FALSE(choose(mesh, 1)[0]);
  SurfaceExtras extras;
  extras.flags.assign(mesh.points.size(), 0);
  extras.flags[48 * 28 + 6 * 7] = kLocked;  // of the eighth octahedron
  const auto goes = choose(mesh, 1, extras);
  CHECK(n_gone(goes) == 19);
  CHECK_FALSE(goes[8]);
  extras.flags.clear();
  extras.tolerance.assign(mesh.points.size(), 1);
  extras.tolerance[48 * 28] = 0;
  CHECK_FALSE(choose(mesh, 1, extras)[1]);
}

TEST_CASE("a piece that goes leaves as many vertices fewer as it still had") {
  // Nine vertices of a small grid, of which some have merged before it goes, and six of each octahedron.
  const IndexedMesh mesh =
      meshes::together({meshes::placed(meshes::flat_grid(3), 0.1, {-9, 0, 0}), meshes::octahedron(),
                        meshes::placed(meshes::octahedron(), 0.8, {9, 0, 0})});
  TargetCount target;
  target.vertices = 7;
  CHECK(pieces_by_error(mesh, pieces_of(mesh), {}, target, 1) == std::vector<bool>{true, false, true});
  target.vertices = 13;
  CHECK(pieces_by_error(mesh, pieces_of(mesh), {}, target, 1) == std::vector<bool>{true, false, false});
}

TEST_CASE("pieces below a size go, without the largest and those with a vertex that is held") {
  const IndexedMesh mesh =
      meshes::together({meshes::placed(meshes::octahedron(), 0.1, {3, 0, 0}), meshes::octahedron(),
                        meshes::placed(meshes::octahedron(), 0.1, {6, 0, 0})});
  SurfaceExtras extras;
  CHECK(detail::pieces_below(mesh, pieces_of(mesh), extras, 10) == std::vector<bool>{true, false, true});
  extras.flags.assign(18, 0);
  extras.flags[2] = kLocked;
  CHECK(detail::pieces_below(mesh, pieces_of(mesh), extras, 10) == std::vector<bool>{false, false, true});
}

TEST_CASE("nothing goes where the target is met already, or there is one piece only") {
  CHECK(n_gone(choose(meshes::dusty_torus(5), 10000)) == 0);
  CHECK(n_gone(choose(meshes::torus(12, 8), 4)) == 0);
  CHECK(choose(IndexedMesh(), 4).empty());
}

TEST_CASE("the choice of pieces is the same on any number of threads") {
  const IndexedMesh mesh = meshes::shaken(meshes::dusty_torus(60), 0.003, 1);
  CHECK(choose(mesh, 400, {}, 1) == choose(mesh, 400, {}, 3));
}
