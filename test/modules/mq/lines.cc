#include "whittle/mq/lines.hh"

#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "mq/Built.hh"
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
  BulkOptions options;
  options.refit = false;
  const auto with = bulk(held, mesh, options), without = bulk(plain, mesh, options);
  CHECK(with.mesh.triangles.size() <= 120);
  CHECK(off_ridge(with.mesh) < 0.5 * off_ridge(without.mesh));
  CHECK(measure::facts(with.mesh).boundary_loops == 1);
  held.feature_angle = 181;
  CHECK_THROWS_AS(held.validate(), InvalidParameter);
}

TEST_CASE("mq's lines hold with nine times their length squared, seams with 0.15 times") {
  mq::Mesh mesh = fixture::built(meshes::strip(3, 2));  // the extent is 2, so an edge of length 1 is 0.5 long
  const mq::Corner along = fixture::corner(mesh, 0, 1), across = fixture::corner(mesh, 1, 4);
  const auto line = mq::line_quadric(mesh, along);
  CHECK(line.xx == 0);
  CHECK(line.yy == Approx(9 * 0.25));
  CHECK(line.zz == Approx(9 * 0.25));
  mesh.has_seams = true;
  mesh.seams.assign(6, 0);
  mesh.table.notes(across).set_seam(across);
  CHECK(mq::line_quadric(mesh, across).xx == Approx(0.15));
  mesh.table.notes(across).set_feature(across);
  CHECK(mq::line_quadric(mesh, across).xx == Approx(9));
}

TEST_CASE("mq visits both boundary edges of a vertex, and each feature there") {
  mq::Mesh mesh = fixture::built(meshes::strip(3, 1));
  const auto neighbours = [&](std::uint32_t v) {
    std::vector<std::uint32_t> out;
    mq::for_each_line(mesh, fixture::vertex(mesh, v),
                      [&](mq::Corner, std::uint32_t w) { out.push_back(mesh.input[w]); });
    std::sort(out.begin(), out.end());
    return out;
  };
  using Numbers = std::vector<std::uint32_t>;
  CHECK(neighbours(1) == Numbers{0, 2});
  CHECK(neighbours(0) == Numbers{1, 3});
  const mq::Corner rung = fixture::corner(mesh, 1, 4), back = mesh.table.twin(rung);
  mesh.table.notes(rung).set_feature(rung);
  mesh.table.notes(back).set_feature(back);
  mesh.has_features = true;
  CHECK(neighbours(1) == Numbers{0, 2, 4});
  CHECK(neighbours(4) == Numbers{1, 3, 5});
}
