#include "whittle/mq/lines.hh"

#include <cmath>

#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "whittle/bulk.hh"
#include "whittle/planners/MemorylessQuadric.hh"

using namespace whittle;
using meshes::IndexedMesh;

TEST_CASE("mq keeps the line of feature edges") {
  // Two planes at 37 degrees, with noise: the ridge runs along y at x = 0.
  IndexedMesh mesh =
      meshes::grid(41, [](std::uint32_t i, std::uint32_t) { return 0.33 * std::abs(20.0 - i); });
  mesh = meshes::shaken(mesh, 0.12, 4);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (v % 41 == 20) mesh.points[v] = Eigen::Vector3d(20, mesh.points[v].y(), 0);
  MemorylessQuadric plain;
  plain.target_faces = 120;
  MemorylessQuadric held = plain;
  held.feature_angle = 30;
  const auto off_ridge = [](const IndexedMesh& out) {  // the ridge's vertices: near it in x
    double worst = 0;
    for (const auto& p : out.points)
      if (std::abs(p.x() - 20) < 0.6) worst = std::max(worst, std::hypot(p.x() - 20, p.z()));
    return worst;
  };
  const auto with = bulk(held, mesh), without = bulk(plain, mesh);
  CHECK(with.mesh.triangles.size() <= 120);
  CHECK(off_ridge(with.mesh) < 0.5 * off_ridge(without.mesh));
  CHECK(measure::facts(with.mesh).boundary_loops == 1);
  held.feature_angle = 181;
  CHECK_THROWS_AS(held.validate(), InvalidParameter);
}
