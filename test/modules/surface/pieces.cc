#include "whittle/surface/pieces.hh"

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;

TEST_CASE("pieces share no vertex, and are counted in the order of their first vertices") {
  IndexedMesh mesh = meshes::together({meshes::tetrahedron(), meshes::lone_triangle(), meshes::octahedron()});
  mesh.points.emplace_back(9, 9, 9);  // in no face
  const Pieces pieces = pieces_of(mesh);
  CHECK(pieces.count() == 3);
  CHECK(pieces.faces == std::vector<std::size_t>{4, 1, 8});
  CHECK(pieces.vertices == std::vector<std::size_t>{4, 3, 6});
  CHECK(pieces.of_vertex == std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 2, 2, Pieces::kNone});
}

TEST_CASE("pieces that touch in a vertex are one") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {5, 5, 5}};
  mesh.triangles = {{1, 2, 0}, {3, 4, 0}};
  const Pieces pieces = pieces_of(mesh);
  CHECK(pieces.faces == std::vector<std::size_t>{2});
  CHECK(pieces.vertices == std::vector<std::size_t>{5});
  CHECK(pieces_of(IndexedMesh()).count() == 0);
}

TEST_CASE("the diagonal of a piece is that of its own box") {
  const IndexedMesh mesh =
      meshes::together({meshes::octahedron(), meshes::placed(meshes::octahedron(), 0.5, {10, 0, 0}),
                        meshes::isolated_points(2)});
  const std::vector<double> diagonals = piece_diagonals(mesh, pieces_of(mesh));
  REQUIRE(diagonals.size() == 2);
  CHECK(diagonals[0] == Approx(std::sqrt(12.0)));
  CHECK(diagonals[1] == Approx(std::sqrt(3.0)));
}
