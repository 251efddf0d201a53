#include "whittle/mq/Partition.hh"

#include <algorithm>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/mq/MortonOrder.hh"
#include "whittle/surface/threads.hh"

using namespace whittle::mq;
using whittle::detail::Crew;

namespace {

CornerTable table_along_curve(const meshes::IndexedMesh& mesh) {
  Crew alone(1);
  const MortonOrder order(mesh);
  return {order.triangles, order.vertex.size(), alone};
}

}  // namespace

TEST_CASE("mq's parts take equally many vertices in a row, and the faces between them") {
  for (const std::uint32_t side : {40u, 50u, 130u, 300u}) {
    const CornerTable table = table_along_curve(meshes::flat_grid(side));
    const Partition partition(table);
    const std::size_t n = table.n_vertices();
    CHECK(partition.size() == (side == 40 ? 1 : side == 50 ? 2 : side == 130 ? 4 : 5));
    CHECK(partition.first_vertex(1) == 0);
    CHECK(partition.first_vertex(partition.size() + 1u) == n);
    CHECK(partition.first_face(1) == 0);
    CHECK(partition.first_face(partition.size() + 1u) == table.n_faces());
    for (PartNumber part = 1; part <= partition.size(); ++part) {
      const std::uint32_t begin = partition.first_vertex(part), end = partition.first_vertex(part + 1u);
      CHECK(end - begin == Approx(double(n) / partition.size()).margin(1));
      REQUIRE(partition.part_of(begin) == part);
      REQUIRE(partition.part_of(end - 1) == part);
      for (std::size_t f = partition.first_face(part); f < partition.first_face(part + 1u); ++f) {
        const auto& t = table.face(corner_of(f)).vertex;
        const auto [least, most] = std::minmax_element(t.begin(), t.end());
        REQUIRE(partition.part_of(*least) == part);
        REQUIRE(partition.part_of(t) == (*most < end ? part : kNoPart));
      }
    }
  }
}

TEST_CASE("mq's partition of a mesh without vertices has one part with nothing in it") {
  const Partition partition(table_along_curve({}));
  CHECK(partition.size() == 1);
  CHECK(partition.first_vertex(2) == 0);
  CHECK(partition.first_face(2) == 0);
}

TEST_CASE("a face's notes keep queued half-edges and lines apart") {
  FaceNotes notes;
  notes.set_queued(8 + 1);
  notes.set_feature(8 + 2);
  for (Corner i = 0; i < 3; ++i) {
    CHECK(notes.is_queued(8 + i) == (i == 1));
    CHECK(notes.is_line(8 + i) == (i == 2));
  }
  notes.clear_queued(8 + 1);
  notes.clear_queued(8 + 2);
  CHECK_FALSE(notes.is_queued(8 + 1));
  CHECK(notes.is_line(8 + 2));
  notes.clear_edges();
  CHECK_FALSE(notes.is_line(8 + 2));
}
