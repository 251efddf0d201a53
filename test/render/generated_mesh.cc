#include "experiment/GeneratedMesh.hh"

#include "catch.hh"
#include "measure/MeshFacts.hh"

using namespace whittle;

TEST_CASE("the generated mesh is closed and of the bunny's size") {
  const auto mesh = bench::generated_mesh();
  const auto facts = measure::facts(mesh);
  CHECK(facts.vertices == 34812);
  CHECK(facts.faces == 69620);
  CHECK(facts.edges == 104430);
  CHECK(facts.closed());
  CHECK(facts.components == 1);
  CHECK(facts.euler_characteristic == 2);
  CHECK(facts.degenerate_faces == 0);
  CHECK(facts.nonmanifold_vertices == 0);
  CHECK(facts.isolated_vertices == 0);
  CHECK(facts.volume > 0);  // faces turn outward
  CHECK(facts.mean_edge == Approx(0.00147).epsilon(1e-9));
  CHECK(bench::mean_edge_length(mesh) == Approx(facts.mean_edge).epsilon(1e-9));
}

TEST_CASE("the generated mesh is no sphere") {
  double nearest = 1e9, farthest = 0;
  for (const auto& p : bench::generated_mesh(10).points) {
    nearest = std::min(nearest, p.norm());
    farthest = std::max(farthest, p.norm());
  }
  CHECK(farthest > 1.2 * nearest);
}

TEST_CASE("the generated mesh is closed and has known counts at every frequency") {
  for (const int f : {1, 2, 3, 8}) {
    const auto facts = measure::facts(bench::generated_mesh(f, 1));
    CHECK(facts.vertices == static_cast<std::size_t>(10 * f * f + 2));
    CHECK(facts.faces == static_cast<std::size_t>(20 * f * f));
    CHECK(facts.closed());
    CHECK(facts.volume > 0);
  }
}
