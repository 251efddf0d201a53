/// \file
/// Boundaries that nearly meet.
#include "files/gaps.hh"

#include "meshes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

/// Two squares side by side, so far apart.
IndexedMesh tiles(double gap) {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0},       {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                 {1 + gap, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1 + gap, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  return mesh;
}

TEST_CASE("gaps: vertices of boundaries beside one another") {
  const Gaps gaps = find_gaps(tiles(1e-6));
  CHECK(gaps.boundary_vertices == 8);
  CHECK(gaps.near == 4);
  CHECK(gaps.length == Approx(std::sqrt(5.0) / 100));
  CHECK(find_gaps(tiles(0)).near == 4);
  CHECK(find_gaps(tiles(0.05)).near == 0);
}

TEST_CASE("gaps: there is none without a boundary") {
  CHECK(find_gaps(meshes::torus(12, 8)).boundary_vertices == 0);
  CHECK(find_gaps({}).near == 0);
}

}  // namespace
}  // namespace whittle::files
