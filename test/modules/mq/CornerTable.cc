#include "whittle/mq/CornerTable.hh"

#include <algorithm>
#include <random>
#include <set>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/surface/Rings.hh"

using namespace whittle::mq;
using meshes::IndexedMesh;
using whittle::Ring;
using whittle::detail::Crew;
using whittle::detail::Rings;

namespace {

struct Nothing {
  std::uint64_t eight_bytes = 0;
};
using Corners = CornerTableT<Nothing>;

Corners table_of(const IndexedMesh& mesh) {
  Crew crew(2);
  return {mesh.triangles, mesh.points.size(), crew};
}

std::vector<Rings::Triangle> alive(const Corners& table) {
  std::vector<Rings::Triangle> out;
  for (std::size_t f = 0; f < table.n_faces(); ++f)
    if (!table.is_dead(corner_of(f))) out.push_back(table.face(corner_of(f)).vertex);
  return out;
}

/// The table's neighbours, and the fans that it walks, are those of its living faces.
void check_consistent(const Corners& table, std::size_t n_vertices) {
  Crew alone(1);
  const Rings rings(alive(table), n_vertices, false, alone);
  for (std::size_t f = 0; f < table.n_faces(); ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3 && !table.is_dead(c); ++c) {
      const Corner d = table.twin(c);
      if (d == kNoCorner) continue;
      REQUIRE_FALSE(table.is_dead(d));
      REQUIRE(table.twin(d) == c);
      REQUIRE(table.vertex(d) == table.vertex(next(c)));
      REQUIRE(table.vertex(next(d)) == table.vertex(c));
    }
  for (std::uint32_t v = 0; v < n_vertices; ++v) {
    const Ring ring = rings[v];
    if (ring.size() == 0) continue;
    REQUIRE(table.is_open(v) == !ring.is_closed());
    std::vector<std::uint32_t> walked;
    Corner at = table.first(v);
    do {
      REQUIRE(table.vertex(at) == v);
      walked.push_back(table.vertex(next(at)));
      at = table.around(at);
    } while (at != kNoCorner && at != table.first(v));
    REQUIRE(walked.size() == ring.n_faces());
    const auto start = std::find(walked.begin(), walked.end(), ring[0]);
    REQUIRE(start != walked.end());
    if (!ring.is_closed()) REQUIRE(start == walked.begin());
    std::rotate(walked.begin(), start, walked.end());
    REQUIRE(std::equal(walked.begin(), walked.end(), ring.begin()));
  }
}

/// The link condition by brute force.
bool may_collapse(const std::vector<Rings::Triangle>& faces, std::uint32_t a, std::uint32_t b) {
  std::set<std::uint32_t> near_a, near_b, opposite;
  std::size_t of_a = 0, of_b = 0;
  for (const auto& t : faces) {
    const bool has_a = std::count(t.begin(), t.end(), a) > 0, has_b = std::count(t.begin(), t.end(), b) > 0;
    of_a += has_a && !has_b;
    of_b += has_b && !has_a;
    for (const std::uint32_t v : t) {
      if (has_a && v != a && v != b) near_a.insert(v);
      if (has_b && v != a && v != b) near_b.insert(v);
      if (has_a && has_b && v != a && v != b) opposite.insert(v);
    }
  }
  std::vector<std::uint32_t> common;
  std::set_intersection(near_a.begin(), near_a.end(), near_b.begin(), near_b.end(),
                        std::back_inserter(common));
  return common.size() == opposite.size() && of_a > 0 && of_b > 0 && of_a + of_b > 2;
}

}  // namespace

TEST_CASE("a corner table follows any legal collapses") {
  for (const IndexedMesh& mesh :
       {meshes::torus(8, 6), meshes::flat_grid(6), meshes::strip(6, 1.0), meshes::octahedron(),
        meshes::cone(7, 1.0), meshes::riddled(meshes::torus(12, 8), 12, 5)}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Corners table = table_of(mesh);
      check_consistent(table, mesh.points.size());
      std::mt19937 random(seed);
      for (int i = 0; i < 300; ++i) {
        const auto c = static_cast<Corner>(corner_of(random() % table.n_faces()) + random() % 3);
        if (table.is_dead(c)) continue;
        const std::uint32_t a = table.vertex(c), b = table.vertex(next(c));
        if (table.first(a) == kNoCorner || table.first(b) == kNoCorner) continue;  // complex
        const bool interior = table.twin(c) != kNoCorner;
        if (interior && table.is_open(a) && table.is_open(b)) continue;
        if (!may_collapse(alive(table), a, b)) continue;
        const std::size_t before = alive(table).size();
        table.collapse(c);
        REQUIRE(alive(table).size() == before - (interior ? 2 : 1));
        REQUIRE(table.first(b) == kNoCorner);
        check_consistent(table, mesh.points.size());
      }
    }
  }
}
