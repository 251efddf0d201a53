#include "whittle/mq/judge.hh"

#include <cstdint>
#include <utility>
#include <vector>

#include "mq/Built.hh"

using namespace whittle;
using fixture::built;
using fixture::corner;
using fixture::worker_of;
using meshes::IndexedMesh;
using mq::Corner;
using mq::Verdict;

namespace {

/// On a copy, as a new worker sets the same marks as the one before.
Verdict judge_at(mq::Mesh mesh, Corner c, const mq::Vec& offset) {
  mq::Worker worker = worker_of(mesh);
  return mq::judge(mesh, c, {offset, 0}, worker);
}
Verdict judge_middle(const mq::Mesh& mesh, Corner c) {
  return judge_at(mesh, c, mesh.edge(c) / 2);
}

}  // namespace

TEST_CASE("mq may collapse an inner edge, and a boundary edge along the boundary") {
  const mq::Mesh mesh = built(meshes::flat_grid(5));
  CHECK(judge_middle(mesh, corner(mesh, 12, 13)) == Verdict::legal);
  CHECK(judge_middle(mesh, corner(mesh, 1, 2)) == Verdict::legal);
}

TEST_CASE("mq refuses an inner edge between two boundary vertices") {
  const mq::Mesh mesh = built(meshes::flat_grid(3));  // its only inner vertex is 4
  CHECK(judge_middle(mesh, corner(mesh, 1, 5)) == Verdict::breaks_link);
}

TEST_CASE("mq refuses an edge whose ends have a third neighbour in common") {
  // 0 1 2 is a cycle around the waist of two tetrahedra without being a face.
  IndexedMesh waist;
  waist.points = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0.7, 1}, {1, 0.7, -1}};
  waist.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  const mq::Mesh mesh = built(waist, {}, {-1, 180, HUGE_VAL});
  for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(2u, 0u)})
    CHECK(judge_middle(mesh, corner(mesh, a, b)) == Verdict::breaks_link);
}

TEST_CASE("mq refuses to leave two faces back to back, or an ear without its tip") {
  const mq::Mesh solid = built(meshes::tetrahedron(), {}, {-1, 180, HUGE_VAL});
  for (Corner c = 0; c < 3; ++c) CHECK(judge_middle(solid, c) == Verdict::breaks_link);
  const mq::Mesh lone = built(meshes::lone_triangle(), {}, {-1, 180, HUGE_VAL});
  for (Corner c = 0; c < 3; ++c) CHECK(judge_middle(lone, c) == Verdict::breaks_link);
}

TEST_CASE("mq refuses to move the boundary into a held inner vertex") {
  SurfaceExtras extras;
  extras.flags.assign(25, 0);
  extras.flags[6] = kLocked;
  const mq::Mesh mesh = built(meshes::flat_grid(5), extras);
  CHECK(judge_at(mesh, corner(mesh, 6, 1), mq::Vec::Zero()) == Verdict::breaks_link);
  const Corner c = corner(mesh, 7, 2);  // not held
  CHECK(judge_at(mesh, c, mesh.edge(c)) == Verdict::legal);
}

TEST_CASE("mq refuses a target that turns a face of the ring over") {
  const mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);
  CHECK(judge_at(mesh, c, 0.9f * mesh.edge(c)) == Verdict::legal);
  CHECK(judge_at(mesh, c, 4 * mesh.edge(c)) == Verdict::turns_face);
}

TEST_CASE("mq refuses a target beyond the bound") {
  const mq::Mesh mesh = built(meshes::flat_grid(5), {}, {0.2f, 180, 0.5});
  const Corner c = corner(mesh, 12, 13);
  const auto height = [&](double model_units) {
    return mq::Vec(mesh.edge(c) / 2 + mq::Vec(0, 0, static_cast<float>(model_units / mesh.scale)));
  };
  CHECK(judge_at(mesh, c, height(0.45)) == Verdict::legal);
  CHECK(judge_at(mesh, c, height(0.55)) == Verdict::breaks_bound);
}

TEST_CASE("mq leaves an edge alone whose ring reaches beyond the worker's part, and only that") {
  mq::Mesh mesh = built(meshes::shaken(meshes::flat_grid(50), 0.2, 1));
  REQUIRE(mesh.partition.size() > 1);
  std::vector<mq::Worker> workers;
  for (unsigned part = 1; part <= mesh.partition.size(); ++part)
    workers.emplace_back(mesh.partition, static_cast<mq::PartNumber>(part));
  std::size_t inside = 0, across = 0;
  for (std::size_t f = 0; f < mesh.table.n_faces(); ++f) {
    const Corner c = mq::corner_of(f);
    const mq::PartNumber part = mesh.table.notes(c).part;
    const std::uint32_t a = mesh.table.vertex(c), b = mesh.table.vertex(mq::next(c));
    if (part == mq::kNoPart || mesh.table.is_open(a) || mesh.table.is_open(b)) continue;
    bool is_inside = true;
    for (const std::uint32_t v : {a, b}) {
      Corner at = mesh.table.first(v);
      do {
        is_inside &= mesh.partition.part_of(mesh.table.vertex(mq::next(at))) == part;
        at = mesh.table.around(at);
      } while (at != mesh.table.first(v));
    }
    mq::Worker& worker = workers[part - 1u];
    REQUIRE((mq::judge(mesh, c, {mesh.edge(c) / 2, 0}, worker) == Verdict::elsewhere) == !is_inside);
    ++(is_inside ? inside : across);
  }
  CHECK(inside > 500);
  CHECK(across > 20);
}

TEST_CASE("mq's marks tell which edges lie around one that was judged since") {
  mq::Mesh mesh = built(meshes::flat_grid(9));
  mq::Worker worker = worker_of(mesh);
  const Corner c = corner(mesh, 40, 41), near = corner(mesh, 31, 22), far = corner(mesh, 10, 11);
  const std::uint32_t before = worker.stamp;
  mq::judge(mesh, c, {mesh.edge(c) / 2, 0}, worker);
  CHECK(mq::is_touched(mesh, c, worker, before));
  CHECK(mq::is_touched(mesh, near, worker, before));  // 31 is next to 40
  CHECK_FALSE(mq::is_touched(mesh, far, worker, before));
  CHECK_FALSE(mq::is_touched(mesh, c, worker, worker.stamp));
}

TEST_CASE("mq moves the boundary into no held inner vertex, from either end of the edge") {
  SurfaceExtras extras;
  extras.flags.assign(25, 0);
  extras.flags[6] = kLocked;
  const mq::Mesh mesh = built(meshes::flat_grid(5), extras);
  const Corner in = corner(mesh, 1, 6), out = corner(mesh, 6, 1);
  CHECK(judge_at(mesh, in, mesh.edge(in)) == Verdict::breaks_link);
  CHECK(judge_at(mesh, out, mq::Vec::Zero()) == Verdict::breaks_link);
}

TEST_CASE("mq may leave one face of three around an inner vertex, at the boundary") {
  const mq::Mesh mesh = built(meshes::cone(3, 0), {}, {-1, 180, HUGE_VAL});
  const Corner out = corner(mesh, 0, 1), in = corner(mesh, 1, 0);
  CHECK(judge_at(mesh, out, mesh.edge(out)) == Verdict::legal);
  CHECK(judge_at(mesh, in, mq::Vec::Zero()) == Verdict::legal);
}

TEST_CASE("mq may take a vertex with three faces out of a closed surface") {
  IndexedMesh mesh = meshes::octahedron();  // with a tip on its face 0 1 4
  REQUIRE(mesh.triangles[0] == IndexedMesh::Triangle{0, 1, 4});
  mesh.points.emplace_back(0.4, 0.4, 0.4);
  mesh.triangles[0] = {0, 1, 6};
  mesh.triangles.push_back({1, 4, 6});
  mesh.triangles.push_back({4, 0, 6});
  const mq::Mesh tipped = built(mesh, {}, {-1, 180, HUGE_VAL});
  CHECK(judge_at(tipped, corner(tipped, 0, 6), mq::Vec::Zero()) == Verdict::legal);
  const Corner from_tip = corner(tipped, 6, 0);
  CHECK(judge_at(tipped, from_tip, tipped.edge(from_tip)) == Verdict::legal);
}

TEST_CASE("mq closes no hole of three edges") {
  IndexedMesh mesh = meshes::triangle_in_hexagon({-0.3, -0.2, 0}, {0.3, -0.2, 0}, {0, 0.3, 0}, 1);
  REQUIRE(mesh.triangles[0] == IndexedMesh::Triangle{0, 1, 2});
  mesh.triangles.erase(mesh.triangles.begin());
  const mq::Mesh holed = built(mesh, {}, {-1, 180, HUGE_VAL});
  for (const auto& [a, b] : {std::pair(1u, 0u), std::pair(2u, 1u), std::pair(0u, 2u)})
    CHECK(judge_middle(holed, corner(holed, a, b)) == Verdict::breaks_link);
}

TEST_CASE("mq's flip guard is a cosine") {
  // To the height h above its middle the edge 12 13 turns its two flattest faces by the angle whose tangent is h.
  const mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);
  const auto lifted = [&](double h) {
    return judge_at(mesh, c, mesh.edge(c) / 2 + mq::Vec(0, 0, static_cast<float>(h / mesh.scale)));
  };
  const double most = std::sqrt(1 / (0.2 * 0.2) - 1);
  CHECK(lifted(0.99 * most) == Verdict::legal);
  CHECK(lifted(1.01 * most) == Verdict::turns_face);
}

TEST_CASE("mq's bound looks at all faces around the edge, those that vanish, too") {
  mq::Mesh mesh = built(meshes::flat_grid(5), {}, {0.2f, 180, 0.5});
  mq::Worker worker = worker_of(mesh);
  const Corner c = corner(mesh, 12, 13);
  REQUIRE(mq::judge(mesh, c, {mesh.edge(c) / 2, 0}, worker) == Verdict::legal);
  CHECK(worker.change.faces.size() == 10);
  CHECK(worker.change.triangles.size() == 8);
}

TEST_CASE("mq's bound is as strict as the tolerance of the vertices that it concerns") {
  SurfaceExtras extras;
  extras.tolerance.assign(49, 1.0f);
  extras.tolerance[40] = 0.1f;
  const mq::Mesh mesh = built(meshes::flat_grid(7), extras, {0.2f, 180, 0.5});
  const auto lifted = [&](std::uint32_t a, std::uint32_t b, double height) {
    const Corner c = corner(mesh, a, b);
    return judge_at(mesh, c, mesh.edge(c) / 2 + mq::Vec(0, 0, static_cast<float>(height / mesh.scale)));
  };
  CHECK(lifted(8, 9, 0.45) == Verdict::legal);
  CHECK(lifted(40, 39, 0.04) == Verdict::legal);
  CHECK(lifted(40, 39, 0.12) == Verdict::breaks_bound);
}

TEST_CASE("mq's marks count at either end of an edge") {
  mq::Mesh mesh = built(meshes::flat_grid(5));
  const Corner c = corner(mesh, 12, 13);
  mq::Worker worker = worker_of(mesh);
  const std::uint32_t since = worker.stamp;
  CHECK_FALSE(mq::is_touched(mesh, c, worker, since));
  worker.stamp += worker.stride;
  for (const std::uint32_t v : {12u, 13u, 7u}) {
    std::uint32_t& mark = mesh.vertices[fixture::vertex(mesh, v)].mark;
    const std::uint32_t before = mark;
    mark = worker.stamp;
    CHECK(mq::is_touched(mesh, c, worker, since) == (v != 7));
    mark = before;
  }
}
