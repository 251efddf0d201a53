#include "whittle/mq/MortonOrder.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "catch.hh"
#include "meshes.hh"

using meshes::IndexedMesh;
using whittle::mq::MortonOrder;

TEST_CASE("Morton order renumbers and loses nothing") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.02, 1);
  const MortonOrder order(mesh, true);
  std::vector<std::uint32_t> vertices = order.vertex;
  std::sort(vertices.begin(), vertices.end());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) REQUIRE(vertices[v] == v);
  std::vector<std::array<std::uint32_t, 3>> faces = order.triangles, expected = mesh.triangles;
  for (auto& t : faces)
    for (std::uint32_t& v : t) v = order.vertex[v];
  REQUIRE(order.face.size() == faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) REQUIRE(faces[f] == mesh.triangles[order.face[f]]);
  std::sort(faces.begin(), faces.end());
  std::sort(expected.begin(), expected.end());
  REQUIRE(faces == expected);
  double near = 0, before = 0;
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    near += (mesh.points[order.vertex[v]] - mesh.points[order.vertex[v - 1]]).norm();
    before += (mesh.points[v] - mesh.points[v - 1]).norm();
  }
  CHECK(near < 2 * before);
  CHECK(MortonOrder(IndexedMesh()).triangles.empty());
  CHECK(MortonOrder(meshes::isolated_points(3)).vertex.size() == 3);
}

TEST_CASE("Morton order tells 1024 places along the longest side apart") {
  IndexedMesh mesh;
  mesh.points = {{1, 0, 0}, {0, 0, 0}, {1023, 0, 0}, {1022, 0, 0}};
  CHECK(MortonOrder(mesh).vertex == std::vector<std::uint32_t>{1, 0, 3, 2});
  mesh.points = {{0.6, 0, 0}, {0, 0, 0}, {1023, 0, 0}};  // the first two in one place: by index
  CHECK(MortonOrder(mesh).vertex == std::vector<std::uint32_t>{0, 1, 2});
}
