#include "whittle/mq/place.hh"

#include <cmath>
#include <cstring>

#include "mq/Built.hh"

using namespace whittle;
using fixture::built;
using fixture::corner;
using meshes::IndexedMesh;
using mq::Corner;
using mq::Placement;

namespace {

/// Two slopes that meet in a ridge at i = 3, 7 by 7; vertex i, j is i + 7 j.
IndexedMesh ridge() {
  return meshes::grid(7, [](std::uint32_t i, std::uint32_t) { return -std::abs(3.0 - i); });
}

Placement place_one(const mq::Mesh& mesh, Corner c) {
  return mq::place(mesh, {c, c, c, c})[0];
}

}  // namespace

TEST_CASE("mq places an edge on a ridge in its middle, and one down a slope at the ridge") {
  const mq::Mesh mesh = built(ridge());
  const Corner along = corner(mesh, 3 + 7 * 2, 3 + 7 * 3), down = corner(mesh, 3 + 7 * 3, 4 + 7 * 3);
  const Placement middle = place_one(mesh, along), top = place_one(mesh, down);
  CHECK((middle.offset - mesh.edge(along) / 2).norm() < 1e-4f);
  CHECK(top.offset.norm() < 1e-4f);
  CHECK(middle.cost < 1e-8f);
  CHECK(top.cost < 1e-8f);
}

TEST_CASE("mq places an edge at the end that is held, whichever it is") {
  SurfaceExtras extras;
  extras.flags.assign(49, 0);
  extras.flags[4 + 7 * 3] = kLocked;
  const mq::Mesh mesh = built(ridge(), extras);
  const Corner from = corner(mesh, 4 + 7 * 3, 3 + 7 * 3), to = corner(mesh, 3 + 7 * 3, 4 + 7 * 3);
  CHECK(place_one(mesh, from).offset == mq::Vec::Zero());
  CHECK(place_one(mesh, to).offset == mesh.edge(to));
  // The other end leaves its ridge: six faces of half a square each, three of them on the far slope.
  CHECK(place_one(mesh, from).cost > 0.001f);
  CHECK(place_one(mesh, from).cost == place_one(mesh, to).cost);
}

TEST_CASE("mq divides the cost by the square of the lesser tolerance of both ends") {
  const IndexedMesh input = meshes::shaken(meshes::flat_grid(7), 0.3, 1);
  SurfaceExtras extras;
  extras.tolerance.assign(49, 1.0f);
  extras.tolerance[3 + 7 * 3] = 0.5f;
  const mq::Mesh plain = built(input), weighted = built(input, extras);
  const auto costs_at = [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(place_one(plain, corner(plain, a, b)).cost,
                     place_one(weighted, corner(weighted, a, b)).cost);
  };
  const auto [cost, heavy] = costs_at(3 + 7 * 3, 3 + 7 * 2);
  CHECK(cost > 0);
  CHECK(heavy == 4 * cost);
  const auto [far, as_before] = costs_at(3 + 7 * 2, 4 + 7 * 2);
  CHECK(as_before == far);
}

TEST_CASE("mq places four edges as each by itself, to the bit") {
  for (const IndexedMesh& input : fixture::sound_meshes()) {
    const mq::Mesh mesh = built(input);
    for (std::size_t f = 0; f + 3 < mesh.table.n_faces(); f += 3) {
      const std::array<Corner, 4> four{mq::corner_of(f), mq::corner_of(f + 1) + 1, mq::corner_of(f + 2) + 2,
                                       mq::corner_of(f + 3)};
      const mq::Placements together = mq::place(mesh, four);
      for (std::size_t i = 0; i < 4; ++i) {
        const Placement alone = place_one(mesh, four[i]);
        REQUIRE(together[i].offset == alone.offset);
        REQUIRE(together[i].cost == alone.cost);
      }
    }
  }
}

TEST_CASE("mq places an edge of no length, or with faces of no area, at a finite point") {
  IndexedMesh input = meshes::flat_grid(5);
  for (auto& p : input.points) p.y() = 0;  // all on a line
  input.points[12] = input.points[13];
  const mq::Mesh mesh = built(input);
  const Placement placed = place_one(mesh, corner(mesh, 12, 13));
  CHECK(placed.offset.allFinite());
  CHECK(placed.cost == 0);
  CHECK(place_one(mesh, corner(mesh, 7, 12)).offset.allFinite());
}

TEST_CASE("mq weighs the planes at both ends of an edge, and a slight pull to its middle") {
  mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);  // along x
  const std::uint32_t a = fixture::vertex(mesh, 12), b = fixture::vertex(mesh, 13);
  const float length = mesh.edge(c).x();
  mesh.areas[a].sum = mesh.areas[b].sum = mq::Vec::Zero();  // the volume says nothing
  const auto placed = [&](const mq::SymmetricMatrix& at_a, const mq::SymmetricMatrix& at_b) {
    mesh.quadrics[a] = at_a;
    mesh.quadrics[b] = at_b;
    Placement placement = place_one(mesh, c);
    placement.offset /= length;
    placement.cost /= length * length;
    return placement;
  };
  const auto plane = [](float x, float z) { return mq::SymmetricMatrix::outer(mq::Vec(x, 0, z), 1); };
  const mq::SymmetricMatrix y = mq::SymmetricMatrix::outer(mq::Vec::UnitY(), 1);

  // x = 0 at the start and y = 0, which weighs so much that the pull, 1e-5 of the trace, is a tenth.
  const Placement pulled = placed(plane(1, 0) + 9999 * y, mq::SymmetricMatrix());
  CHECK(pulled.offset.x() == Approx(0.05 / 1.1).epsilon(1e-4));
  CHECK(pulled.cost == Approx(0.05 / 1.1 * 0.05 / 1.1).epsilon(1e-3));
  CHECK(placed(mq::SymmetricMatrix(), plane(1, 0) + 9999 * y).offset.x() == Approx(1.05 / 1.1).epsilon(1e-4));

  // Planes that rise by s from the start and by 1 from the end meet at x = 1 / (1 - s). Up to two lengths from the
  // middle the vertex goes there; beyond, it stays in the middle, and costs what the planes say there.
  const Placement near = placed(plane(0.5f, -1) + y, plane(1, -1) + y),
                  far = placed(plane(0.6f, -1) + y, plane(1, -1) + y);
  CHECK((near.offset - mq::Vec(2, 0, 1)).norm() < 1e-2f);
  CHECK(near.cost < 1e-3f);
  CHECK(far.offset == mq::Vec(0.5f, 0, 0));
  CHECK(far.cost == Approx(0.3 * 0.3 + 0.5 * 0.5).epsilon(1e-5));
}

TEST_CASE(
    "mq places an edge where the planes leave a direction open so that the volume stays, which costs "
    "nothing") {
  mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);  // along x
  const std::uint32_t a = fixture::vertex(mesh, 12), b = fixture::vertex(mesh, 13);
  const float length = mesh.edge(c).x();
  // y = 0 and z = 0, x is open: a rod along the edge, whose ends are caps of 1 at the start and of 3 at the end.
  mesh.quadrics[a] = mesh.quadrics[b] =
      mq::SymmetricMatrix::outer(mq::Vec::UnitY(), 1) + mq::SymmetricMatrix::outer(mq::Vec::UnitZ(), 1);
  mesh.areas[a].sum = {1, 0, 0};
  mesh.areas[b].sum = {3, 0, 0};
  const Placement kept = place_one(mesh, c);
  CHECK(kept.offset.x() / length == Approx(0.75).epsilon(1e-4));  // the pull to the middle is 1e-6 as strong
  CHECK(kept.cost < 1e-4f * length * length);
  mesh.areas[b].sum = {0, 0, 0};
  CHECK(std::abs(place_one(mesh, c).offset.x()) < 1e-4f * length);
  mesh.areas[a].sum = {0, 0, 0};
  CHECK(place_one(mesh, c).offset.x() / length == Approx(0.5));
}

TEST_CASE("mq's cost at a held end is what the planes of the other end say there") {
  mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);
  const std::uint32_t a = fixture::vertex(mesh, 12), b = fixture::vertex(mesh, 13);
  mesh.quadrics[a] = mq::SymmetricMatrix::identity(3);
  mesh.quadrics[b] = mq::SymmetricMatrix::identity(7);
  mesh.all_free = false;
  const float square = mesh.edge(c).squaredNorm();
  mesh.holds[a] = mq::kFixed;
  CHECK(place_one(mesh, c).cost == 7 * square);
  mesh.holds[a] = mq::kFree;
  mesh.holds[b] = mq::kFixed;
  CHECK(place_one(mesh, c).cost == 3 * square);
  CHECK(mesh.is_movable(c));
  mesh.holds[a] = mq::kFixed;  // two that are held stay apart
  CHECK_FALSE(mesh.is_movable(c));
  mesh.holds[a] = mq::kUntouchable;
  mesh.holds[b] = mq::kFree;
  CHECK_FALSE(mesh.is_movable(c));
}

TEST_CASE("mq takes the terms of the values at each end from that end's faces") {
  // The value is x up to the column 3 and constant from there, so along the edge 23 -> 24, from x = 2 to 3, it is
  // linear at 23 and has a bend at 24.
  const IndexedMesh input = meshes::flat_grid(7);
  SurfaceExtras extras;
  extras.n_values = 1;
  for (const auto& p : input.points) extras.values.push_back(static_cast<float>(std::min(p.x(), 3.0)));
  const mq::Mesh mesh = built(input, extras);
  const Placement forth = place_one(mesh, corner(mesh, 23, 24)), back = place_one(mesh, corner(mesh, 24, 23));
  CHECK((forth.offset - mesh.edge(corner(mesh, 23, 24))).norm() < 1e-3f);  // the bend stays
  CHECK(back.offset.norm() < 1e-3f);
}

TEST_CASE("mq's cost is what the planes say where it places an edge, though the volume has moved it there") {
  mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);  // along x
  const std::uint32_t a = fixture::vertex(mesh, 12), b = fixture::vertex(mesh, 13);
  const float length = mesh.edge(c).x();
  const auto along = [](const mq::Vec& axis) { return mq::SymmetricMatrix::outer(axis, 1); };
  mesh.quadrics[b] = along(mq::Vec::UnitY()) + along(mq::Vec::UnitZ());
  mesh.quadrics[a] = mesh.quadrics[b] + along(mq::Vec::UnitX());
  mesh.areas[a].sum = {1, 0, 0};
  mesh.areas[b].sum = {3, 0, 0};
  // x x + 2 (4 x - 3) (4 x - 3) in units of the length, as 10 by the trace of both is 2, is least at 24 / 33.
  const Placement placed = place_one(mesh, c);
  CHECK(placed.offset.x() / length == Approx(24.0 / 33).epsilon(1e-4));
  CHECK(placed.cost / (length * length) == Approx(24.0 / 33 * 24 / 33).epsilon(1e-3));
}
