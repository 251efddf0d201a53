#include "speed/subdivide.hh"

#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "peers/precision.hh"

using namespace whittle;

namespace {

IndexedMesh subdivided(const IndexedMesh& mesh) {
  return peers::in_double(speed::subdivide(peers::in_float(mesh)));
}

}  // namespace

TEST_CASE("a subdivided torus has four times the faces and is as manifold") {
  const auto coarse = measure::facts(meshes::torus(12, 8));
  const auto fine = measure::facts(subdivided(meshes::torus(12, 8)));
  CHECK(fine.faces == 4 * coarse.faces);
  CHECK(fine.vertices == coarse.vertices + coarse.edges);
  CHECK(fine.closed());
  CHECK(fine.nonmanifold_vertices == 0);
  CHECK(fine.euler_characteristic == 0);
  CHECK(fine.degenerate_faces == 0);
  CHECK(fine.area == Approx(coarse.area).epsilon(0.01));
}

TEST_CASE("subdivision keeps boundaries") {
  const auto fine = measure::facts(subdivided(meshes::flat_grid(4)));
  CHECK(fine.boundary_edges == 2 * 12);
  CHECK(fine.boundary_loops == 1);
  CHECK(fine.nonmanifold_edges == 0);
}

TEST_CASE(
    "subdivision keeps old points and moves new ones off the edge by up to a hundredth of it, never by 0") {
  const IndexedMesh fine = subdivided(meshes::flat_grid(2));
  REQUIRE(fine.points.size() == 4 + 5);
  CHECK(fine.points[3] == IndexedMesh::Point(1, 1, 0));
  for (std::size_t v = 4; v < fine.points.size(); ++v) {
    CHECK(fine.points[v].z() != 0);
    CHECK(std::abs(fine.points[v].z()) <= 0.01 * std::sqrt(2.0));
  }
}

TEST_CASE("subdivision is deterministic, and the checksum tells meshes apart") {
  const auto torus = peers::in_float(meshes::torus(12, 8));
  CHECK(speed::checksum(speed::subdivide(torus)) == speed::checksum(speed::subdivide(torus)));
  auto other = torus;
  std::swap(other.triangles[0], other.triangles[1]);
  CHECK(speed::checksum(other) != speed::checksum(torus));
}
