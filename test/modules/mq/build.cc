#include "whittle/mq/build.hh"

#include <array>

#include "mq/Built.hh"

using namespace whittle;
using fixture::built;
using fixture::vertex;
using meshes::IndexedMesh;

TEST_CASE("mq plans on a copy of unit size") {
  IndexedMesh input = meshes::shaken(meshes::torus(24, 12), 0.01, 1);
  for (auto& p : input.points) p = 1000 * p + Eigen::Vector3d(5000, 0, -300);
  const mq::Mesh mesh = built(input);
  mq::Vec low = mesh.vertices[0].position, high = low;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const mq::Vec& p = mesh.vertices[v].position;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    const Eigen::Vector3d back = mesh.scale * p.cast<double>() + mesh.center;
    CHECK((back - input.points[mesh.input[v]]).norm() < 1e-4);
  }
  CHECK((high - low).maxCoeff() == Approx(1));
  CHECK((high + low).norm() < 1e-6f);
}

TEST_CASE("mq fixes what is held and never touches a vertex without a ring") {
  IndexedMesh input = meshes::flat_grid(5);
  input.points.emplace_back(2, 2, 1);
  input.triangles.push_back({12, 13, 25});  // a third face at that edge
  SurfaceExtras extras;
  extras.flags.assign(26, 0);
  extras.flags[6] = kSeam;
  const mq::Mesh mesh = built(input, extras), free = built(meshes::flat_grid(5));
  CHECK(mesh.holds[vertex(mesh, 6)] == mq::kFixed);
  CHECK(mesh.holds[vertex(mesh, 7)] == mq::kFree);
  CHECK(mesh.holds[vertex(mesh, 12)] == mq::kUntouchable);
  CHECK_FALSE(mesh.all_free);
  CHECK(free.all_free);
}

TEST_CASE("mq knows lines where there is a boundary or a feature") {
  CHECK(built(meshes::flat_grid(5)).has_lines);
  const mq::Mesh closed = built(meshes::octahedron()),
                 creased = built(meshes::octahedron(), {}, {0.2f, 60, 1});
  CHECK_FALSE(closed.has_lines);
  CHECK_FALSE(closed.has_features);
  CHECK(creased.has_features);
  for (std::size_t f = 0; f < 8; ++f)
    for (mq::Corner c = mq::corner_of(f); c < mq::corner_of(f) + 3; ++c) {
      CHECK(creased.table.notes(c).is_line(c));
      CHECK_FALSE(closed.table.notes(c).is_line(c));
    }
}

TEST_CASE("mq's features add their line once to either end") {
  const mq::Mesh plain = built(meshes::octahedron()),
                 creased = built(meshes::octahedron(), {}, {0.2f, 60, 1});
  for (std::uint32_t v = 0; v < 6;
       ++v) {  // four edges of squared length 1/2 each, which hold in two directions
    CHECK(creased.quadrics[v].trace() - plain.quadrics[v].trace() == Approx(4 * 2 * 9 * 0.5).epsilon(1e-5));
    CHECK(creased.input[v] == plain.input[v]);
  }
}

TEST_CASE("mq's faces have the reference normals, or their own where there are none") {
  const IndexedMesh grid = meshes::flat_grid(3);
  SurfaceExtras extras;
  for (std::size_t f = 0; f < grid.triangles.size(); ++f)
    extras.reference_normals.emplace_back(f == 2 ? 3 : 0, 0, f == 2 ? 0 : f == 5 ? 0 : -1e-3);
  const mq::Mesh given = built(grid, extras), own = built(grid);
  std::array<int, 3> counts{};
  for (std::size_t f = 0; f < grid.triangles.size(); ++f) {
    const std::uint32_t bits = given.table.notes(mq::corner_of(f)).normal.bits();
    counts[0] += bits == mq::PackedNormal(mq::Vec::UnitX()).bits();
    counts[1] += bits == mq::PackedNormal(mq::Vec(-mq::Vec::UnitZ())).bits();
    counts[2] += bits == mq::PackedNormal().bits();
    CHECK(own.table.notes(mq::corner_of(f)).normal.bits() == mq::PackedNormal(mq::Vec::UnitZ()).bits());
  }
  CHECK(counts == std::array<int, 3>{1, 6, 1});
}

TEST_CASE("mq's mesh is the same to the bit for any number of threads") {
  const IndexedMesh input = meshes::shaken(meshes::torus(120, 60), 0.001, 1);
  const mq::Mesh one = built(input);
  REQUIRE(one.partition.size() > 1);
  for (const std::size_t n_threads : {2u, 5u}) {
    const mq::Mesh many = built(input, {}, fixture::kUsual, n_threads);
    CHECK(many.input == one.input);
    for (std::size_t v = 0; v < one.quadrics.size(); ++v) {
      REQUIRE(many.quadrics[v].xx == one.quadrics[v].xx);
      REQUIRE(many.quadrics[v].yz == one.quadrics[v].yz);
      REQUIRE(many.table.first(static_cast<std::uint32_t>(v)) ==
              one.table.first(static_cast<std::uint32_t>(v)));
    }
  }
}

TEST_CASE("mq's weights are the inverse squares of the tolerances, its values in units of the mesh") {
  const IndexedMesh grid = meshes::flat_grid(5);  // 4 wide
  SurfaceExtras extras;
  extras.tolerance.assign(25, 1.0f);
  extras.tolerance[7] = 0.5f;
  extras.tolerance[8] = 2.0f;
  extras.tolerance[9] = 1e-9f;
  extras.n_values = 2;
  for (std::size_t v = 0; v < 25; ++v)
    for (const std::size_t value : {v, 100 * v}) extras.values.push_back(static_cast<float>(value));
  const mq::Mesh mesh = built(grid, extras);
  CHECK(mesh.weights[vertex(mesh, 6)] == 1);
  CHECK(mesh.weights[vertex(mesh, 7)] == 4);
  CHECK(mesh.weights[vertex(mesh, 8)] == 0.25f);
  CHECK(mesh.weights[vertex(mesh, 9)] == Approx(1e8));
  CHECK(mesh.values.at(vertex(mesh, 8))[0] == 2);
  CHECK(mesh.values.at(vertex(mesh, 8))[1] == 200);
}

TEST_CASE("mq's untouchable vertices stay so when they are locked") {
  IndexedMesh input = meshes::flat_grid(3);
  input.points.emplace_back(1, 1, 1);
  input.triangles.push_back({4, 1, 9});  // a third face at the edge 1 4
  SurfaceExtras extras;
  extras.flags.assign(10, kLocked);
  const mq::Mesh mesh = built(input, extras);
  CHECK(mesh.holds[vertex(mesh, 4)] == mq::kUntouchable);
  CHECK(mesh.holds[vertex(mesh, 5)] == mq::kFixed);
}

TEST_CASE("mq's reference normals go with their faces through the new order") {
  const IndexedMesh grid = meshes::flat_grid(4);
  for (std::size_t marked = 0; marked < grid.triangles.size(); ++marked) {
    SurfaceExtras extras;
    extras.reference_normals.assign(grid.triangles.size(), Eigen::Vector3d::UnitZ());
    extras.reference_normals[marked] = Eigen::Vector3d::UnitX();
    const mq::Mesh mesh = built(grid, extras);
    for (std::size_t f = 0; f < grid.triangles.size(); ++f) {
      const mq::Corner c = mq::corner_of(f);
      std::array<std::uint32_t, 3> t{};
      for (std::uint32_t k = 0; k < 3; ++k) t[k] = mesh.input[mesh.table.vertex(c + k)];
      const bool is_x = mesh.table.notes(c).normal.bits() == mq::PackedNormal(mq::Vec::UnitX()).bits();
      REQUIRE(is_x == (t == grid.triangles[marked]));
    }
  }
}

TEST_CASE("mq knows the normal of a face of very little area") {
  IndexedMesh thin;  // a box of 2 around the origin, so that small coordinates stay exact
  thin.points = {{-1, 0, 0}, {1, 0, 0}, {0, 1e-10, 0}, {0, 1, 1}, {0, -1, -1}};
  thin.triangles = {{0, 1, 2}};
  CHECK(built(thin).table.notes(0).normal.bits() == mq::PackedNormal(mq::Vec::UnitZ()).bits());
  thin.points[2].y() = 0;
  CHECK(built(thin).table.notes(0).normal.bits() == mq::PackedNormal().bits());
}
