/// \file
/// What must hold on the real bunny at the papers' settings.
#include <map>

#include "catch.hh"
#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "whittle/FaceAngle.hh"
#include "whittle/VertexDistance.hh"
#include "whittle/execute.hh"

using namespace whittle;

namespace {

template <typename Planner>
void check_set(const IndexedMesh& bunny, const Planner& planner, double percent_removed) {
  const auto out = execute(planner.plan(SurfaceT<double>(bunny)), bunny);
  const double before = double(bunny.triangles.size()), after = double(out.mesh.triangles.size());
  CHECK(100 * (1 - after / before) == Approx(percent_removed).margin(0.1));

  const auto facts = measure::facts(out.mesh);
  CHECK(facts.nonmanifold_edges == 0);
  CHECK(facts.nonmanifold_vertices == 0);
  CHECK(facts.boundary_edges == 0);
  CHECK(facts.euler_characteristic == 2);
  CHECK(facts.degenerate_faces == 0);
  CHECK(facts.duplicate_faces == 0);

  const auto normal = [](const IndexedMesh& mesh, std::size_t f) {
    const auto& t = mesh.triangles[f];
    const Eigen::Vector3d a = mesh.points[t[0]];
    return Eigen::Vector3d((mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).normalized());
  };
  double least = 1;
  for (std::size_t f = 0; f < out.face_origin.size(); ++f)
    least = std::min(least, normal(out.mesh, f).dot(normal(bunny, out.face_origin[f])));
  CHECK(least > 0.2);

  const auto distance = measure::distance(bunny, out.mesh);
  CHECK(distance.two_sided.mean < 5e-5);
  CHECK(double(distance.flipped_faces) <= after * 2e-4);  // thin places confuse the nearest face
}

}  // namespace

TEST_CASE("the papers' settings on the bunny", "[bunny]") {
  IndexedMesh bunny;
  try {
    bunny = files::read_mesh(WHITTLE_ASSETS "/cache/bunny.obj").mesh;
  } catch (const files::FileError&) {
    WARN("skipped: assets/fetch.sh bunny has not been run");
    return;
  }
  REQUIRE(bunny.points.size() == 34835);
  REQUIRE(bunny.triangles.size() == 69666);
  FaceAngle fad;
  VertexDistance ivdd;
  SECTION("FAD, 30 degrees") {
    check_set(bunny, fad, 24.7);
  }
  SECTION("FAD, 150 degrees") {
    fad.max_normal_angle = 150;
    check_set(bunny, fad, 25.3);
  }
  SECTION("IVDD, 0.0011") {
    ivdd.max_distance = 0.0011;
    check_set(bunny, ivdd, 36.8);
  }
  SECTION("IVDD, 0.0013") {
    ivdd.max_distance = 0.0013;
    check_set(bunny, ivdd, 44.1);
  }
}
