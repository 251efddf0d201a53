#include "whittle/ModFaceAngleT.hh"

#include "OpenMeshFixture.hh"

using namespace whittle;
using fixture::Mesh;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;

TEST_CASE("ModFaceAngleT removes the tip of a flat cone") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::cone(6, 0.05));
  const auto out = fixture::run<OpenMesh::Decimater::DecimaterT, ModFaceAngleT>(
      mesh, [](auto& fad) { fad.set_max_normal_angle(30); });
  CHECK(out.triangles.size() == 4);
}

TEST_CASE("ModFaceAngleT takes the threshold as a normal angle or as an included angle") {
  Mesh mesh;
  ModFaceAngleT<Mesh> fad(mesh);
  CHECK(fad.planner().max_normal_angle == 30);
  fad.set_min_included_angle(120);
  CHECK(fad.planner().max_normal_angle == 60);
  CHECK(fad.name() == "FaceAngle");
}

TEST_CASE("every setter of ModFaceAngleT reaches the planner") {
  Mesh mesh;
  ModFaceAngleT<Mesh> fad(mesh);
  fad.set_pairs(FaceAngle::Pairs::all);
  fad.set_count(3);
  fad.set_max_area(2);
  fad.set_lock(FaceAngle::Lock::strict);
  fad.set_apex(FaceAngle::Apex::lexicographic);
  fad.set_flip_guard(-1);
  CHECK(fad.planner().pairs == FaceAngle::Pairs::all);
  CHECK(fad.planner().count == 3);
  CHECK(fad.planner().max_area == 2);
  CHECK(fad.planner().lock == FaceAngle::Lock::strict);
  CHECK(fad.planner().apex == FaceAngle::Apex::lexicographic);
  CHECK(fad.planner().guard.min_cos == -1);
}

TEST_CASE("a bad value is refused by the setter, and the old one stays") {
  Mesh mesh;
  ModFaceAngleT<Mesh> fad(mesh);
  CHECK_THROWS_AS(fad.set_max_normal_angle(-1), InvalidParameter);
  CHECK_THROWS_AS(fad.set_min_included_angle(181), InvalidParameter);
  CHECK_THROWS_AS(fad.set_max_area(0), InvalidParameter);
  CHECK_THROWS_AS(fad.set_count(-2), InvalidParameter);
  CHECK_THROWS_AS(fad.set_flip_guard(1), InvalidParameter);
  CHECK(fad.planner().max_normal_angle == 30);
  CHECK(fad.planner().guard.min_cos == FlipGuard().min_cos);
}

TEST_CASE("ModFaceAngleT beside a stock module does no more than alone") {
  const auto start = meshes::shaken(meshes::torus(24, 14), 0.01, 5);
  Mesh mesh = fixture::to_openmesh<Mesh>(start);
  mesh.request_face_normals();
  mesh.update_face_normals();
  Decimater decimater(mesh);
  ModFaceAngleT<Mesh>::Handle fad;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(fad);
  decimater.add(flipping);
  decimater.module(fad).set_max_normal_angle(90);
  REQUIRE(decimater.initialize());
  const std::size_t planned = decimater.module(fad).plan().collapses.size();
  SECTION("a weak constraint lets all of the plan pass") {
    decimater.module(flipping).set_max_normal_deviation(179);
    CHECK(decimater.decimate() == planned);
  }
  SECTION("a strong one holds some of it back") {
    decimater.module(flipping).set_max_normal_deviation(5);
    const std::size_t done = decimater.decimate();
    CHECK(done > 0);
    CHECK(done < planned);
  }
}
