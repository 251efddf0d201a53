#include "render/MeshBuffers.hh"

#include "catch.hh"
#include "triangles.hh"

using namespace whittle;

TEST_CASE("a flat triangle's normals point to where it turns counter-clockwise") {
  for (const auto& normal : render::vertex_normals(corner_triangle()))
    CHECK(normal == Eigen::Vector3f(0, 0, 1));
}

TEST_CASE("normals are weighted by area") {
  // Around the x axis: one face of area 2 toward z, one of area 1 toward y.
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  const auto normals = render::vertex_normals(mesh);
  const Eigen::Vector3f shared = Eigen::Vector3f(0, -1, 2).normalized();
  CHECK((normals[0] - shared).norm() < 1e-6f);
  CHECK((normals[1] - shared).norm() < 1e-6f);
  CHECK(normals[2] == Eigen::Vector3f(0, 0, 1));
  CHECK(normals[3] == Eigen::Vector3f(0, -1, 0));
}

TEST_CASE("vertices without a face of positive area get some normal") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}};
  for (const auto& normal : render::vertex_normals(mesh)) CHECK(normal == Eigen::Vector3f(0, 0, 1));
}

TEST_CASE("the bounding box holds all points, used or not") {
  auto mesh = corner_triangle();
  mesh.points.push_back({9, -9, 1});
  const auto box = render::bounding_box(mesh);
  CHECK(box.min() == Eigen::Vector3d(-0.5, -9, 0));
  CHECK(box.max() == Eigen::Vector3d(9, 0.5625, 1));
  CHECK(render::bounding_box({}).isEmpty());
}
