#include "model/StandIn.hh"

#include <algorithm>
#include <cmath>

#include "catch.hh"
#include "measure/Distance.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::viewer;

TEST_CASE("a stand-in has few triangles and the same shape") {
  const IndexedMesh mesh = meshes::torus(100, 60);
  const auto stand_in = make_stand_in(mesh, 2000);
  REQUIRE(stand_in);
  CHECK(stand_in->triangles.size() <= 2000);
  CHECK(stand_in->triangles.size() > 1900);
  CHECK(stand_in->vertex_map.size() == mesh.points.size());
  IndexedMesh coarse;
  for (const auto& point : stand_in->arrays.positions)
    coarse.points.push_back(point.cast<double>() + stand_in->arrays.origin);
  coarse.triangles = stand_in->triangles;
  const measure::Distance distance = measure::distance(mesh, coarse, {20000, 1});
  CHECK(distance.two_sided.rms < 0.003 * distance.diagonal);
}

TEST_CASE("small meshes need no stand-in, and a heap of triangles has none") {
  CHECK_FALSE(make_stand_in(meshes::torus(40, 24), 1000));
  CHECK_FALSE(make_stand_in({}, 10));
  IndexedMesh heap;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const double x = 3.0 * i;
    for (const auto& point :
         {Eigen::Vector3d(x, 0, 0), Eigen::Vector3d(x + 1, 0, 0), Eigen::Vector3d(x, 1, 0)})
      heap.points.push_back(point);
    heap.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  CHECK_FALSE(make_stand_in(heap, 100));
}

TEST_CASE("values go to a stand-in as their root mean square") {
  const IndexedMesh mesh = meshes::torus(100, 60);
  const auto stand_in = make_stand_in(mesh, 2000);
  REQUIRE(stand_in);
  const auto same = values_on(*stand_in, std::vector<float>(mesh.points.size(), 3));
  CHECK(same == std::vector<float>(stand_in->arrays.positions.size(), 3));
  std::vector<float> one(mesh.points.size(), 0);
  one[17] = 12;
  const auto spread = values_on(*stand_in, one);
  const auto merged =
      std::count(stand_in->vertex_map.begin(), stand_in->vertex_map.end(), stand_in->vertex_map[17]);
  CHECK(spread[stand_in->vertex_map[17]] == Approx(12 / std::sqrt(static_cast<double>(merged))));
  CHECK(values_on(*stand_in, {}).empty());
}
