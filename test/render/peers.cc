#include "experiment/Peers.hh"

#include <algorithm>

#include "catch.hh"
#include "experiment/GeneratedMesh.hh"
#include "measure/MeshFacts.hh"
#include "peers/vertex_cache.hh"

using namespace whittle;

TEST_CASE("each peer reaches the number of triangles on a closed mesh and keeps it closed") {
  const auto mesh = bench::generated_mesh(20);
  for (const auto& peer : bench::peers()) {
    INFO(peer.name);
    const auto result = peer.simplify(mesh, 4000);
    CHECK(result.mesh.triangles.size() == 4000);
    const auto facts = measure::facts(result.mesh);
    CHECK(facts.closed());
    CHECK(facts.isolated_vertices == 0);
  }
}

TEST_CASE("OpenMesh and meshoptimizer are always among the peers") {
  REQUIRE(bench::peers().size() >= 2);
  CHECK(bench::peers()[0].name == "openmesh");
  CHECK(bench::peers()[1].name == "meshopt");
}

TEST_CASE("vertex-cache order keeps every triangle and misses less") {
  auto mesh = bench::generated_mesh(20);
  // Far-apart triangles after one another: the worst order.
  IndexedMesh scattered = mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    scattered.triangles[i] = mesh.triangles[i * 4999 % mesh.triangles.size()];
  auto ordered = peers::vertex_cache_order(scattered);
  CHECK(ordered.points == mesh.points);
  CHECK(peers::cache_misses_per_triangle(scattered) > 2.5);
  CHECK(peers::cache_misses_per_triangle(ordered) < 1);

  const auto sorted = [](IndexedMesh m) {
    for (auto& t : m.triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(m.triangles.begin(), m.triangles.end());
    return m.triangles;
  };
  CHECK(sorted(ordered) == sorted(mesh));
}

TEST_CASE("a lone triangle fetches its three vertices, no triangle none") {
  CHECK(peers::cache_misses_per_triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}) == 3);
  CHECK(peers::cache_misses_per_triangle({}) == 0);
}
