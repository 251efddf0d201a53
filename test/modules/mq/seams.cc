#include "whittle/mq/seams.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "charts.hh"
#include "mq/Built.hh"
#include "whittle/mq/collapse.hh"
#include "whittle/mq/judge.hh"
#include "whittle/plan/execute.hh"
#include "whittle/plan/merged_wedges.hh"

using namespace whittle;
using fixture::built;
using fixture::corner;
using fixture::vertex;
using fixture::worker_of;
using meshes::IndexedMesh;
using mq::Corner;
using mq::kNoCorner;
using mq::Verdict;

namespace {

/// A grid whose charts are divided by the lines x = each of these.
SurfaceExtras in_stripes(const IndexedMesh& mesh, const std::vector<double>& lines) {
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(mesh, meshes::charts_by_centre(mesh, [&](const meshes::Point& p) {
                                      std::uint32_t n = 0;
                                      for (const double x : lines) n += p.x() > x;
                                      return n;
                                    }));
  return extras;
}

/// These faces are a chart, all others another.
SurfaceExtras with_island(const IndexedMesh& mesh, const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint32_t> chart(mesh.triangles.size(), 0);
  for (const std::uint32_t f : faces) chart[f] = 1;
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(mesh, chart);
  return extras;
}

/// Grid of 5 by 5 with a slit from 7 over 12 to 17: corners at 12 differ left and right of it.
SurfaceExtras with_slit(const IndexedMesh& grid) {
  SurfaceExtras extras;
  for (const auto& t : grid.triangles) {
    const double middle = (grid.points[t[0]].x() + grid.points[t[1]].x() + grid.points[t[2]].x()) / 3;
    auto& corners = extras.wedges.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) corners[k] = t[k] + (t[k] == 12 && middle > 2 ? 100 : 0);
  }
  return extras;
}

mq::Placement placed(const mq::Mesh& mesh, Corner c) {
  return mq::place(mesh, {c, c, c, c})[0];
}
Verdict seam_verdict(mq::Mesh mesh, std::uint32_t from, std::uint32_t to) {
  mq::Worker worker = worker_of(mesh);
  const Corner c = corner(mesh, from, to);
  return mq::judge(mesh, c, placed(mesh, c), worker);
}

/// Where the edge would merge, in the input's coordinates.
Eigen::Vector3d seam_target(const mq::Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  const Corner c = corner(mesh, from, to);
  return mesh.center + mesh.scale * (mesh.position(c) + placed(mesh, c).offset).cast<double>();
}

Collapse merge(mq::Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  for (mq::Vertex& v : mesh.vertices) v.mark = 0;  // of an earlier worker
  mq::Worker worker = worker_of(mesh);
  const Corner c = corner(mesh, from, to);
  const mq::Placement placement = placed(mesh, c);
  REQUIRE(mq::judge(mesh, c, placement, worker) == Verdict::legal);
  std::array<Corner, 2> unqueued;
  return mq::collapse(mesh, c, placement, worker, unqueued);
}

std::uint32_t n_seams(const mq::Mesh& mesh, std::uint32_t v) {
  return mesh.seams[vertex(mesh, v)];
}
bool is_seam(const mq::Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  const Corner c = corner(mesh, from, to);
  return mesh.table.notes(c).is_seam(c);
}
std::size_t all_seams(const mq::Mesh& mesh) {
  std::size_t n = 0;
  for (Corner f = 0; f < mq::corner_of(mesh.table.n_faces()); f += mq::corner_of(1))
    for (Corner c = f; c < f + 3; ++c) n += !mesh.table.is_dead(f) && mesh.table.notes(c).is_seam(c);
  return n / 2;
}

/// Both half-edges of an edge are marked or none, none at the boundary, and the counts are right.
void check_seams(const mq::Mesh& mesh) {
  std::vector<std::uint32_t> counts(mesh.seams.size(), 0);
  for (Corner f = 0; f < mq::corner_of(mesh.table.n_faces()); f += mq::corner_of(1))
    for (Corner c = f; c < f + 3 && !mesh.table.is_dead(f); ++c) {
      if (!mesh.table.notes(c).is_seam(c)) continue;
      const Corner d = mesh.table.twin(c);
      REQUIRE(d != kNoCorner);
      REQUIRE(mesh.table.notes(d).is_seam(d));
      ++counts[mesh.table.vertex(c)];
    }
  for (std::uint32_t v = 0; v < counts.size(); ++v)
    if (mesh.table.first(v) != kNoCorner) REQUIRE(counts[v] == mesh.seams[v]);
}

/// Collapses edges at random. \return  what was done, in order
CollapsePlan collapse_some(mq::Mesh& mesh, std::size_t faces_left) {
  std::mt19937 random(7);
  mq::Worker worker = worker_of(mesh);
  CollapsePlan plan;
  std::size_t n_faces = mesh.table.n_faces();
  for (int i = 0; i < 100000 && n_faces > faces_left; ++i) {
    const auto c = static_cast<Corner>(mq::corner_of(random() % mesh.table.n_faces()) + random() % 3);
    if (mesh.table.is_dead(c) || !mesh.is_movable(c)) continue;
    const mq::Placement placement = placed(mesh, c);
    if (mq::judge(mesh, c, placement, worker) != Verdict::legal) continue;
    std::array<Corner, 2> unqueued;
    plan.collapses.push_back(mq::collapse(mesh, c, placement, worker, unqueued));
    n_faces -= plan.collapses.back().faces;
  }
  return plan;
}

}  // namespace

TEST_CASE("mq: an inner edge is a seam if the wedges of its faces differ at either end") {
  const IndexedMesh grid = meshes::flat_grid(5);
  const mq::Mesh mesh = built(grid, in_stripes(grid, {2}));
  CHECK(mesh.has_seams);
  CHECK(mesh.has_lines);
  CHECK_FALSE(mesh.all_free);
  CHECK(all_seams(mesh) == 4);
  CHECK(is_seam(mesh, 12, 17));
  CHECK_FALSE(is_seam(mesh, 11, 12));
  CHECK(n_seams(mesh, 12) == 2);
  CHECK(n_seams(mesh, 2) == 1);
  CHECK(n_seams(mesh, 11) == 0);
  check_seams(mesh);

  const mq::Mesh slit = built(grid, with_slit(grid));
  CHECK(all_seams(slit) == 2);
  CHECK(slit.holds[vertex(slit, 7)] == mq::kFixed);
  CHECK(slit.holds[vertex(slit, 12)] == mq::kFree);
}

TEST_CASE("mq: wedges that agree make no seam, and change nothing") {
  const IndexedMesh grid = meshes::flat_grid(5);
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(grid, std::vector<std::uint32_t>(grid.triangles.size(), 3));
  const mq::Mesh mesh = built(grid, extras);
  CHECK_FALSE(mesh.has_seams);
  CHECK(mesh.all_free);
  CHECK(mesh.seams.empty());
}

TEST_CASE("mq: two vertices on a straight seam merge along it, anywhere between them") {
  const IndexedMesh grid = meshes::flat_grid(7);
  mq::Mesh mesh = built(grid, in_stripes(grid, {3}));
  CHECK(seam_target(mesh, 24, 31).isApprox(Eigen::Vector3d(3, 3.5, 0), 1e-6));
  merge(mesh, 24, 31);
  CHECK(all_seams(mesh) == 5);
  CHECK(n_seams(mesh, 24) == 2);
  check_seams(mesh);
}

TEST_CASE("mq: a vertex inside a chart merges into one on the seam, which stays") {
  const IndexedMesh grid = meshes::flat_grid(7);
  for (const bool from_seam : {false, true}) {
    mq::Mesh mesh = built(grid, in_stripes(grid, {3}));
    const Collapse done = from_seam ? merge(mesh, 24, 23) : merge(mesh, 23, 24);
    CHECK(done.from == 23);
    CHECK(done.to == 24);
    CHECK(done.target.isApprox(Eigen::Vector3d(3, 3, 0), 1e-6));
    CHECK(all_seams(mesh) == 6);
    check_seams(mesh);
  }
}

TEST_CASE("mq: a seam drags no chart of one face along unless it may, but one of two faces") {
  const IndexedMesh grid = meshes::flat_grid(7);
  const auto verdict = [&](bool is_whole_square, float share) {
    SurfaceExtras extras = in_stripes(grid, {3});
    std::vector<std::uint32_t> chart = meshes::charts_by_centre(grid, [&](const meshes::Point& p) {
      const bool in_square = p.x() > 3 && p.x() < 4 && p.y() > 3 && p.y() < 4;
      return in_square && (is_whole_square || p.y() - 3 > p.x() - 3) ? 2u : p.x() > 3 ? 1u : 0u;
    });
    extras.wedges = meshes::wedges_of(grid, chart);
    mq::Mesh mesh = built(grid, extras);
    mq::Worker worker = worker_of(mesh);
    const Corner c = corner(mesh, 24, 17);  // along the seam, away from the square over 24
    const mq::Placement placement{share * mesh.edge(c), 0};
    CHECK(mq::judge(mesh, c, placement, worker, true) == Verdict::legal);
    return mq::judge(mesh, c, placement, worker);
  };
  // The edge opposite 24 in the upper half of the square is as long as the one that collapses.
  CHECK(verdict(false, 0.45f) == Verdict::legal);
  CHECK(verdict(false, 0.55f) == Verdict::breaks_seam);
  CHECK(verdict(true, 0.55f) == Verdict::legal);
}

TEST_CASE("mq: two seams never merge across the chart between them") {
  const IndexedMesh grid = meshes::flat_grid(7);
  const mq::Mesh mesh = built(grid, in_stripes(grid, {3, 4}));
  CHECK(seam_verdict(mesh, 24, 25) == Verdict::breaks_seam);
  CHECK(seam_verdict(mesh, 24, 31) == Verdict::legal);
  SurfaceExtras extras = in_stripes(grid, {3});
  extras.flags.assign(grid.points.size(), 0);
  extras.flags[23] = kLocked;  // neither may move
  CHECK(seam_verdict(built(grid, extras), 23, 24) == Verdict::breaks_seam);
}

TEST_CASE("mq: where a seam meets the boundary it stays, and others merge into it") {
  const IndexedMesh grid = meshes::flat_grid(7);
  const mq::Mesh mesh = built(grid, in_stripes(grid, {3}));
  for (const auto& [from, to] : {std::pair(2u, 3u), std::pair(3u, 4u), std::pair(10u, 3u)}) {
    CHECK(seam_verdict(mesh, from, to) == Verdict::legal);
    CHECK(seam_target(mesh, from, to).isApprox(Eigen::Vector3d(3, 0, 0), 1e-6));
  }
  CHECK(seam_verdict(mesh, 2, 10) == Verdict::breaks_link);  // the boundary would have to come to the seam
  CHECK(seam_verdict(built(grid, in_stripes(grid, {3, 4})), 3, 4) == Verdict::breaks_seam);
}

TEST_CASE("mq: a chart of one face vanishes, and the chart around it closes") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  const SurfaceExtras extras = with_island(mesh, {0});
  mq::Mesh closing = built(mesh, extras);
  REQUIRE(all_seams(closing) == 3);
  merge(closing, 0, 1);
  CHECK(all_seams(closing) == 0);
  for (std::uint32_t v = 1; v < 9; ++v) CHECK(n_seams(closing, v) == 0);
  check_seams(closing);

  const mq::Mesh kept = built(mesh, extras, {0.2f, 180, HUGE_VAL, true});
  for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(2u, 0u)})
    CHECK(seam_verdict(kept, a, b) == Verdict::breaks_seam);
}

TEST_CASE("mq: between two charts the seam remains when the one that parted them vanishes") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  // Three charts around the triangle, the fan at each of its corners with what follows it.
  std::vector<std::uint32_t> chart = {0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(mesh, chart);
  mq::Mesh closing = built(mesh, extras);
  REQUIRE(all_seams(closing) == 6);
  merge(closing, 0, 1);
  check_seams(closing);
  CHECK(is_seam(closing, 0, 2));
  CHECK(n_seams(closing, 0) == 3);
  CHECK(n_seams(closing, 2) == 2);
  CHECK(all_seams(closing) == 4);
}

TEST_CASE("mq: a slit grows by the chart of one face that vanishes at its end") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  SurfaceExtras extras = with_island(mesh, {0});
  REQUIRE(mesh.triangles[1] == IndexedMesh::Triangle{0, 3, 4});
  REQUIRE(mesh.triangles[9] == IndexedMesh::Triangle{2, 3, 0});
  extras.wedges[1][0] = extras.wedges[9][2] = 100;  // the slit is from 0 to 4 at the boundary
  mq::Mesh closing = built(mesh, extras);
  REQUIRE(all_seams(closing) == 4);
  merge(closing, 0, 1);
  check_seams(closing);
  CHECK(all_seams(closing) == 2);
  CHECK(is_seam(closing, 0, 4));
  CHECK(is_seam(closing, 0, 2));
  CHECK(closing.holds[vertex(closing, 2)] == mq::kFixed);
}

TEST_CASE("mq: the last face of a chart at the boundary vanishes along the boundary") {
  const IndexedMesh grid = meshes::flat_grid(5);
  REQUIRE(grid.triangles[2] == IndexedMesh::Triangle{1, 2, 7});
  mq::Mesh mesh = built(grid, with_island(grid, {2}));
  REQUIRE(all_seams(mesh) == 2);
  merge(mesh, 1, 2);
  CHECK(all_seams(mesh) == 0);
  check_seams(mesh);
  CHECK(seam_verdict(built(grid, with_island(grid, {2}), {0.2f, 180, HUGE_VAL, true}), 1, 2) ==
        Verdict::breaks_seam);
  CHECK(seam_verdict(built(grid, with_island(grid, {2, 3})), 1, 2) == Verdict::breaks_seam);
}

TEST_CASE("mq: a slit keeps its ends and one vertex between them") {
  const IndexedMesh grid = meshes::flat_grid(5);
  const mq::Mesh mesh = built(grid, with_slit(grid));
  CHECK(seam_verdict(mesh, 12, 7) == Verdict::breaks_seam);
  CHECK(seam_verdict(mesh, 12, 17) == Verdict::breaks_seam);
  CHECK(seam_verdict(mesh, 11, 12) == Verdict::legal);
  CHECK(seam_verdict(mesh, 6, 7) == Verdict::legal);
  CHECK(seam_target(mesh, 6, 7).isApprox(Eigen::Vector3d(2, 1, 0), 1e-6));
}

TEST_CASE("mq: an edge that is a feature and a seam counts as a feature") {
  const IndexedMesh ridge = meshes::grid(7, [](std::uint32_t i, std::uint32_t) { return std::abs(3.0 - i); });
  const mq::Mesh both = built(ridge, in_stripes(ridge, {3}), {0.2f, 30, HUGE_VAL}),
                 feature = built(ridge, {}, {0.2f, 30, HUGE_VAL}),
                 seam = built(ridge, in_stripes(ridge, {3}));
  const std::uint32_t v = vertex(both, 24);
  CHECK(both.quadrics[v].trace() == feature.quadrics[v].trace());
  CHECK(seam.quadrics[v].trace() < feature.quadrics[v].trace());
  CHECK(seam_verdict(both, 24, 25) == Verdict::legal);
  check_seams(both);
}

TEST_CASE("mq's seams after many collapses are those of the wedges that are left") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const IndexedMesh open = meshes::riddled(meshes::shaken(meshes::flat_grid(30), 0.1, 2), 60, 5);
  for (const IndexedMesh& input : {torus, open})
    for (const std::size_t size : {3u, 12u, 60u}) {
      SurfaceExtras extras;
      extras.wedges = meshes::wedges_of(input, meshes::grown_charts(input, size, 4));
      mq::Mesh mesh = built(input, extras);
      check_seams(mesh);
      const CollapsePlan plan = collapse_some(mesh, input.triangles.size() / 4);
      CHECK(plan.collapses.size() > input.triangles.size() / 6);
      check_seams(mesh);

      const auto left = execute(plan, input);
      const meshes::Wedges wedges = merged_wedges(
          {input.triangles, left.mesh.triangles, left.vertex_map, left.face_origin, left.mesh.points.size()},
          extras.wedges);
      std::vector<std::uint32_t> face_left(input.triangles.size());
      for (std::uint32_t f = 0; f < left.face_origin.size(); ++f) face_left[left.face_origin[f]] = f;
      const std::vector<std::uint32_t> input_face = mq::MortonOrder(input, true).face;
      const auto wedge = [&](Corner c) {
        const std::uint32_t f = face_left[input_face[mq::face_of(c)]];
        const auto& t = left.mesh.triangles[f];
        const std::uint32_t v = left.vertex_map[mesh.input[mesh.table.vertex(c)]];
        return wedges[f][static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin())];
      };
      std::size_t torn = 0, needless = 0, n = 0;
      for (Corner f = 0; f < mq::corner_of(mesh.table.n_faces()); f += mq::corner_of(1))
        for (Corner c = f; c < f + 3 && !mesh.table.is_dead(f); ++c) {
          const Corner d = mesh.table.twin(c);
          if (d == kNoCorner) continue;
          const bool differs = wedge(c) != wedge(mq::next(d)) || wedge(mq::next(c)) != wedge(d);
          torn += differs && !mesh.table.notes(c).is_seam(c);
          needless += !differs && mesh.table.notes(c).is_seam(c);
          n += mesh.table.notes(c).is_seam(c);
        }
      CHECK(torn == 0);
      CHECK(needless <= n / 50);
    }
}

TEST_CASE("mq: where a slit branches, a branch may go") {
  const IndexedMesh grid = meshes::flat_grid(5);
  SurfaceExtras extras = with_slit(grid);  // and another branch from 12 to 13
  for (std::size_t f = 0; f < grid.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = grid.triangles[f];
      const double height = (grid.points[t[0]].y() + grid.points[t[1]].y() + grid.points[t[2]].y()) / 3;
      if (extras.wedges[f][k] == 112 && height > 2) extras.wedges[f][k] = 212;
    }
  const mq::Mesh mesh = built(grid, extras);
  REQUIRE(all_seams(mesh) == 3);
  for (const std::uint32_t end : {7u, 17u, 13u}) CHECK_FALSE(mq::closes_slit(mesh, corner(mesh, 12, end)));
  CHECK(mq::closes_slit(built(grid, with_slit(grid)), corner(built(grid, with_slit(grid)), 12, 7)));
}

namespace {

/// A fan of n faces around vertex 0, a ring of n more fields outside; each face of the fan has a wedge of its own at 0.
SurfaceExtras pole(std::uint32_t n, IndexedMesh& mesh) {
  mesh = {};
  mesh.points.emplace_back(0, 0, 0);
  for (const double r : {1.0, 2.0})
    for (std::uint32_t i = 0; i < n; ++i)
      mesh.points.emplace_back(r * std::cos(2 * meshes::kPi * i / n), r * std::sin(2 * meshes::kPi * i / n),
                               0);
  SurfaceExtras extras;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 1 + i, b = 1 + (i + 1) % n;
    mesh.triangles.push_back({0, a, b});
    extras.wedges.push_back({100 + i, a, b});
    for (const auto& t : {IndexedMesh::Triangle{a, a + n, b + n}, IndexedMesh::Triangle{a, b + n, b}}) {
      mesh.triangles.push_back(t);
      extras.wedges.push_back(t);
    }
  }
  return extras;
}

}  // namespace

TEST_CASE("mq: spokes merge at their outer ends until three are left") {
  IndexedMesh fan;
  const SurfaceExtras extras = pole(6, fan);
  mq::Mesh mesh = built(fan, extras);
  CHECK(n_seams(mesh, 0) == 6);
  CHECK(n_seams(mesh, 1) == 1);
  CHECK(mesh.is_movable(corner(mesh, 1, 2)));
  CHECK(merge(mesh, 2, 1).faces == 2);
  CHECK(n_seams(mesh, 0) == 5);
  check_seams(mesh);
  merge(mesh, 4, 3);
  merge(mesh, 6, 5);
  CHECK(n_seams(mesh, 0) == 3);
  check_seams(mesh);
  std::size_t movable = 0;
  for (Corner f = 0; f < mq::corner_of(mesh.table.n_faces()); f += mq::corner_of(1))
    for (Corner c = f; c < f + 3 && !mesh.table.is_dead(f); ++c) movable += mesh.joins_spokes(c);
  CHECK(movable == 0);
}

TEST_CASE("mq: spokes that are locked stay, and three at a hub") {
  IndexedMesh fan;
  SurfaceExtras extras = pole(6, fan);
  extras.flags.assign(fan.points.size(), 0);
  extras.flags[1] = kLocked;
  const mq::Mesh locked = built(fan, extras);
  CHECK_FALSE(locked.is_movable(corner(locked, 1, 2)));
  CHECK(locked.is_movable(corner(locked, 2, 3)));

  const SurfaceExtras few = pole(3, fan);
  const mq::Mesh three = built(fan, few);
  CHECK_FALSE(three.is_movable(corner(three, 1, 2)));
}
