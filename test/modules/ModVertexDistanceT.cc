#include "whittle/ModVertexDistanceT.hh"

#include "OpenMeshFixture.hh"

using namespace whittle;
using fixture::Mesh;

TEST_CASE("ModVertexDistanceT folds a triangle to its centre") {
  const Mesh mesh =
      fixture::to_openmesh<Mesh>(meshes::triangle_in_hexagon({0, 0, 0}, {0.25, 0, 0}, {0.125, 0.25, 0}, 1));
  const auto out = fixture::run<OpenMesh::Decimater::DecimaterT, ModVertexDistanceT>(
      mesh, [](auto& ivdd) { ivdd.set_max_distance(0.5); });
  CHECK(out.triangles.size() == 6);
  CHECK(out.points[0] == Eigen::Vector3f(0.125f, 0.09375f, 0));
}

TEST_CASE("every setter of ModVertexDistanceT reaches the planner, and bad values do not") {
  Mesh mesh;
  ModVertexDistanceT<Mesh> ivdd(mesh);
  CHECK_FALSE(ivdd.planner().max_distance);
  CHECK(ivdd.name() == "VertexDistance");
  ivdd.set_max_distance(0.5);
  ivdd.set_placement(VertexDistance::Placement::circumcenter);
  ivdd.set_flip_guard(0.5);
  CHECK_THROWS_AS(ivdd.set_max_distance(-1), InvalidParameter);
  CHECK_THROWS_AS(ivdd.set_max_distance(std::nan("")), InvalidParameter);
  CHECK_THROWS_AS(ivdd.set_flip_guard(-2), InvalidParameter);
  CHECK(ivdd.planner().max_distance == 0.5);
  CHECK(ivdd.planner().placement == VertexDistance::Placement::circumcenter);
  CHECK(ivdd.planner().guard.min_cos == 0.5);
}

TEST_CASE("ModVertexDistanceT beside a stock module does no more than alone") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.01, 5));
  mesh.request_face_normals();
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(ivdd);
  decimater.add(flipping);
  decimater.module(ivdd).set_max_distance(0.15);
  decimater.module(flipping).set_max_normal_deviation(15);
  REQUIRE(decimater.initialize());
  const std::size_t planned = decimater.module(ivdd).plan().collapses.size(), done = decimater.decimate();
  CHECK(done > 0);
  CHECK(done < planned);
}
