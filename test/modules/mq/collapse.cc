#include "whittle/mq/collapse.hh"

#include <cmath>
#include <random>
#include <vector>

#include "mq/Built.hh"
#include "whittle/mq/judge.hh"

using namespace whittle;
using fixture::built;
using fixture::corner;
using fixture::worker_of;
using meshes::IndexedMesh;
using mq::Corner;
using mq::kNoCorner;
using mq::SymmetricMatrix;
using mq::Values;

namespace {

/// The quadrics of all vertices, and the slopes of the values, summed anew from the faces that are left.
std::vector<SymmetricMatrix> summed(const mq::Mesh& mesh, Values& values) {
  const std::uint32_t n = static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<SymmetricMatrix> sums(n);
  for (std::uint32_t v = 0; v < n && !values.empty(); ++v) {
    const auto own = values.between(v, v, 0);
    values.set(v, own, values.no_term());
  }
  for (std::size_t f = 0; f < mesh.table.n_faces(); ++f) {
    const Corner p = mq::corner_of(f), q = p + 1, r = p + 2;
    if (mesh.table.is_dead(p)) continue;
    SymmetricMatrix quadric = mq::face_quadric(mesh.edge(p).cross(-mesh.edge(r)));
    if (!values.empty()) {
      const auto term =
          values.term(mesh.position(p), mesh.position(q), mesh.position(r), values.at(mesh.table.vertex(p)),
                      values.at(mesh.table.vertex(q)), values.at(mesh.table.vertex(r)));
      quadric += term.form;
      for (const Corner c : {p, q, r}) values.add(mesh.table.vertex(c), term);
    }
    for (const Corner c : {p, q, r}) {
      sums[mesh.table.vertex(c)] += quadric;
      const Corner d = mesh.table.twin(c);
      if (d != kNoCorner && !(mesh.table.notes(c).is_line(c) && c < d)) continue;
      for (const Corner end : {c, mq::next(c)}) sums[mesh.table.vertex(end)] += mq::line_quadric(mesh, c);
    }
  }
  return sums;
}

float difference(const SymmetricMatrix& a, const SymmetricMatrix& b) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.xy - b.xy), std::abs(a.xz - b.xz), std::abs(a.yy - b.yy),
                   std::abs(a.yz - b.yz), std::abs(a.zz - b.zz)});
}

/// Whether the area vectors are those of the faces that are left.
void check_areas(const mq::Mesh& mesh) {
  std::vector<mq::Vec> sums(mesh.vertices.size(), mq::Vec::Zero());
  for (std::size_t f = 0; f < mesh.table.n_faces(); ++f) {
    const Corner c = mq::corner_of(f);
    if (mesh.table.is_dead(c)) continue;
    for (const Corner at : {c, c + 1, c + 2})
      sums[mesh.table.vertex(at)] += mesh.edge(c).cross(-mesh.edge(c + 2));
  }
  float most = 0;
  for (const mq::Vec& sum : sums) most = std::max(most, sum.norm());
  for (std::uint32_t v = 0; v < sums.size(); ++v)
    if (mesh.table.first(v) != kNoCorner) REQUIRE((mesh.areas[v].sum - sums[v]).norm() <= 1e-4f * most);
}

/// Whether all quadrics, area vectors, and what the values add to edges, are those of the faces that are left.
void check_quadrics(const mq::Mesh& mesh) {
  check_areas(mesh);
  Values values = mesh.values;
  const std::vector<SymmetricMatrix> sums = summed(mesh, values);
  float most = 0;
  for (const SymmetricMatrix& sum : sums) most = std::max(most, sum.trace());
  for (std::uint32_t v = 0; v < sums.size(); ++v)
    if (mesh.table.first(v) != kNoCorner) REQUIRE(difference(mesh.quadrics[v], sums[v]) < 1e-4f * most);
  if (values.empty()) return;
  for (std::size_t f = 0; f < mesh.table.n_faces(); ++f) {
    const Corner c = mq::corner_of(f);
    if (mesh.table.is_dead(c)) continue;
    const std::uint32_t a = mesh.table.vertex(c), b = mesh.table.vertex(mq::next(c));
    const mq::Vec e = mesh.edge(c);
    const auto along = [&](const Values& of) {
      const mq::FourVectors edges(mq::Four(e.x()), mq::Four(e.y()), mq::Four(e.z()));
      return mq::one_of(of.along({a, a, a, a}, {b, b, b, b}, edges)[0], 0);
    };
    REQUIRE(difference(along(mesh.values), along(values)) < 1e-4f * most);
  }
}

/// Collapses edges at random until few faces are left. \return  how many
std::size_t collapse_many(mq::Mesh& mesh, const IndexedMesh& input) {
  std::mt19937 random(3);
  mq::Worker worker = worker_of(mesh);
  std::vector<bool> is_gone(input.points.size(), false);
  std::size_t n_faces = input.triangles.size(), count = 0;
  for (int i = 0; i < 20000 && n_faces > input.triangles.size() / 4; ++i) {
    const auto c = static_cast<Corner>(mq::corner_of(random() % mesh.table.n_faces()) + random() % 3);
    if (mesh.table.is_dead(c) || !mesh.is_movable(c)) continue;
    const mq::Placement placement = mq::place(mesh, {c, c, c, c})[0];
    if (mq::judge(mesh, c, placement, worker) != mq::Verdict::legal) continue;
    const bool is_boundary = mesh.table.twin(c) == kNoCorner;
    const std::uint32_t to = mesh.table.vertex(c);
    std::array<Corner, 2> unqueued;
    const Collapse done = mq::collapse(mesh, c, placement, worker, unqueued);
    REQUIRE(done.faces == (is_boundary ? 1 : 2));
    REQUIRE_FALSE(is_gone[done.from]);
    REQUIRE_FALSE(is_gone[done.to]);
    is_gone[done.from] = true;
    REQUIRE(mesh.input[to] == done.to);
    REQUIRE((mesh.vertices[to].position.cast<double>() * mesh.scale + mesh.center - done.target).norm() <
            1e-12);
    n_faces -= done.faces;
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("mq's collapses keep the quadrics those of the faces that are left") {
  for (const IndexedMesh& input : fixture::sound_meshes()) {
    mq::Mesh mesh = built(input);
    check_quadrics(mesh);
    CHECK(collapse_many(mesh, input) > 0);
    check_quadrics(mesh);
  }
}

TEST_CASE("mq's collapses keep the planes of feature edges") {
  const IndexedMesh input = meshes::shaken(meshes::torus(24, 12), 0.01, 1);
  mq::Mesh mesh = built(input, {}, {0.2f, 30, HUGE_VAL});
  REQUIRE(mesh.has_features);
  check_quadrics(mesh);
  CHECK(collapse_many(mesh, input) > 50);
  check_quadrics(mesh);
}

TEST_CASE("mq's collapses keep the terms of the values") {
  const IndexedMesh input = meshes::shaken(meshes::flat_grid(12), 0.1, 2);
  SurfaceExtras extras;
  extras.n_values = 2;
  for (const auto& p : input.points)
    for (const double value : {std::sin(p.x()), p.x() * p.y() / 10}) extras.values.push_back(float(value));
  mq::Mesh mesh = built(input, extras);
  check_quadrics(mesh);
  CHECK(collapse_many(mesh, input) > 50);
  check_quadrics(mesh);
}

TEST_CASE("the end that is held survives mq's collapse under its own name") {
  SurfaceExtras extras;
  extras.flags.assign(25, 0);
  extras.flags[13] = kFeature;
  for (const bool from_held : {false, true}) {
    mq::Mesh mesh = built(meshes::flat_grid(5), extras);
    mq::Worker worker = worker_of(mesh);
    const Corner c = from_held ? corner(mesh, 13, 12) : corner(mesh, 12, 13);
    const mq::Placement placement = mq::place(mesh, {c, c, c, c})[0];
    REQUIRE(mq::judge(mesh, c, placement, worker) == mq::Verdict::legal);
    std::array<Corner, 2> unqueued;
    const Collapse done = mq::collapse(mesh, c, placement, worker, unqueued);
    CHECK(done.from == 12);
    CHECK(done.to == 13);
    CHECK(done.target.isApprox(Eigen::Vector3d(3, 2, 0), 1e-6));
    CHECK(mesh.holds[fixture::vertex(mesh, 13)] == mq::kFixed);
  }
}

TEST_CASE("two edges that a collapse fuses are queued once if either was") {
  // The faces of 12 -> 13 are 12 13 18 to its left and 12 7 13 to its right.
  enum Queued { none, outer, inner, both_outer };
  for (const Queued which : {none, outer, inner, both_outer}) {
    mq::Mesh mesh = built(meshes::flat_grid(5));
    mq::Worker worker = worker_of(mesh);
    auto& table = mesh.table;
    const Corner c = corner(mesh, 12, 13), left = table.twin(mq::next(c)),
                 right = table.twin(mq::previous(c));
    if (which == outer) table.notes(right).set_queued(right);
    if (which == inner) table.notes(c).set_queued(mq::next(c));
    if (which == both_outer)
      for (const Corner at : {left, right}) table.notes(at).set_queued(at);
    const mq::Placement placement{mesh.edge(c) / 2, 0};
    REQUIRE(mq::judge(mesh, c, placement, worker) == mq::Verdict::legal);
    std::array<Corner, 2> unqueued;
    mq::collapse(mesh, c, placement, worker, unqueued);
    REQUIRE(table.twin(left) == right);
    const int queued = table.notes(left).is_queued(left) + table.notes(right).is_queued(right);
    CHECK(queued == (which == outer || which == both_outer ? 1 : 0));
    const bool is_handed_over = unqueued[0] == left || unqueued[0] == right;
    CHECK(is_handed_over == (which == inner));
    CHECK(unqueued[1] == kNoCorner);
    CHECK_FALSE(table.notes(c).is_queued(mq::next(c)));  // its face has vanished
  }
}

namespace {

/// Collapses an edge to a share of its length. \return the half-edge, whose face is gone
Corner collapse_to(mq::Mesh& mesh, std::uint32_t start, std::uint32_t end, float share) {
  mq::Worker worker = worker_of(mesh);
  const Corner c = corner(mesh, start, end);
  const mq::Placement placement{share * mesh.edge(c), 0};
  REQUIRE(mq::judge(mesh, c, placement, worker) == mq::Verdict::legal);
  std::array<Corner, 2> unqueued;
  mq::collapse(mesh, c, placement, worker, unqueued);
  return c;
}

}  // namespace

TEST_CASE("the survivor of mq's collapse has the value at its place on the edge, and none beyond its ends") {
  SurfaceExtras extras;
  extras.n_values = 1;
  for (const auto& p : meshes::flat_grid(5).points) extras.values.push_back(static_cast<float>(p.x()));
  for (const auto& [share, x] :
       {std::pair(0.25f, 2.25f), std::pair(0.75f, 2.75f), std::pair(1.25f, 3.0f), std::pair(-0.25f, 2.0f)}) {
    mq::Mesh mesh = built(meshes::flat_grid(5), extras);
    REQUIRE(mesh.scale == 4);
    const std::uint32_t to = fixture::vertex(mesh, 12);
    collapse_to(mesh, 12, 13, share);
    CHECK(*mesh.values.at(to) == Approx(x / 4));
  }
}

TEST_CASE("the survivor of mq's collapse has the larger weight of both ends") {
  SurfaceExtras extras;
  extras.tolerance.assign(25, 1.0f);
  extras.tolerance[13] = 0.5f;
  for (const bool heavy_first : {false, true}) {
    mq::Mesh mesh = built(meshes::flat_grid(5), extras);
    const std::uint32_t to = fixture::vertex(mesh, heavy_first ? 13 : 12);
    collapse_to(mesh, heavy_first ? 13 : 12, heavy_first ? 12 : 13, 0.5f);
    CHECK(mesh.weights[to] == 4);
  }
}

TEST_CASE("mq's feature lines go on through collapses beside them, each edge once") {
  // A ridge along the column 2: 2 7 12 17 22. The face 7 13 12 is on the side of 13.
  const IndexedMesh roof = meshes::grid(5, [](std::uint32_t i, std::uint32_t) { return -std::abs(2.0 - i); });
  for (const auto& [start, end] :
       {std::pair(12u, 13u), std::pair(13u, 12u), std::pair(7u, 13u), std::pair(13u, 7u)}) {
    SurfaceExtras extras;  // the ridge stays where it is
    extras.flags.assign(25, 0);
    for (const std::size_t v : {2u, 7u, 12u, 17u, 22u}) extras.flags[v] = kFeature;
    mq::Mesh mesh = built(roof, extras, {0.2f, 60, HUGE_VAL});
    collapse_to(mesh, start, end, start == 13 ? 1.0f : 0.0f);
    std::size_t half_edges = 0;
    for (std::size_t f = 0; f < mesh.table.n_faces(); ++f)
      for (Corner c = mq::corner_of(f); c < mq::corner_of(f) + 3; ++c)
        half_edges += !mesh.table.is_dead(c) && mesh.table.notes(c).is_feature(c);
    CHECK(half_edges == 8);
    const Corner kept = corner(mesh, 7, 12);
    CHECK(mesh.table.notes(kept).is_feature(kept));
    check_quadrics(mesh);
  }
}

TEST_CASE("a queued edge of a face that mq's collapse takes is handed over, on whichever side it was") {
  for (const bool is_next : {false, true}) {
    mq::Mesh mesh = built(meshes::flat_grid(5));
    mq::Worker worker = worker_of(mesh);
    const Corner c = corner(mesh, 12, 13);
    mesh.table.notes(c).set_queued(is_next ? mq::next(c) : mq::previous(c));
    const mq::Placement placement{mesh.edge(c) / 2, 0};
    REQUIRE(mq::judge(mesh, c, placement, worker) == mq::Verdict::legal);
    std::array<Corner, 2> unqueued;
    mq::collapse(mesh, c, placement, worker, unqueued);
    CHECK(unqueued[0] != kNoCorner);
    CHECK(unqueued[1] == kNoCorner);
  }
}

TEST_CASE("mq's bound has no point in a face that is gone, and each point once") {
  const auto n_points = [](const mq::Mesh& mesh, const std::vector<std::uint32_t>& faces) {
    mq::Bound::Change change;
    change.faces = faces;
    change.triangles = {{0, {-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}};
    mesh.bound->allows(change);
    return change.moves.size();
  };
  std::vector<std::uint32_t> all;
  for (std::uint32_t f = 0; f < 32; ++f) all.push_back(f);
  std::size_t before = 0;
  for (const auto& [start, end] : {std::pair(6u, 7u), std::pair(11u, 12u), std::pair(16u, 17u)}) {
    mq::Mesh mesh = built(meshes::flat_grid(5), {}, {0.2f, 180, 100});
    REQUIRE(n_points(mesh, all) == 25);
    const Corner c = corner(mesh, start, end);
    const std::vector<std::uint32_t> gone{mq::face_of(c), mq::face_of(mesh.table.twin(c))};
    before += n_points(mesh, gone);
    collapse_to(mesh, start, end, 0.5f);
    CHECK(n_points(mesh, gone) == 0);
    CHECK(n_points(mesh, all) == 25);
  }
  CHECK(before > 0);
}

TEST_CASE("a vertex of very many faces survives mq's collapse, unless the other end is held") {
  IndexedMesh bipyramid = meshes::cone(100, 1);  // the tip is 0, the other one 101
  bipyramid.points.emplace_back(0, 0, -1);
  for (std::uint32_t i = 0; i < 100; ++i) bipyramid.triangles.push_back({101, (i + 1) % 100 + 1, i + 1});
  for (const bool is_held : {false, true})
    for (const bool from_tip : {false, true}) {
      SurfaceExtras extras;
      extras.flags.assign(102, 0);
      if (is_held) extras.flags[7] = kLocked;
      mq::Mesh mesh = built(bipyramid, extras, {-1, 180, HUGE_VAL});
      mq::Worker worker = worker_of(mesh);
      const Corner c = from_tip ? corner(mesh, 0, 7) : corner(mesh, 7, 0);
      // Where 7 is held, at 7, with which faces of the far side turn upright; so these have no normal to keep.
      const mq::Placement placement{from_tip == is_held ? mesh.edge(c) : mq::Vec(mq::Vec::Zero()), 0};
      for (std::size_t f = 0; f < 200; ++f) mesh.table.notes(mq::corner_of(f)).normal = mq::PackedNormal();
      REQUIRE(mq::judge(mesh, c, placement, worker) == mq::Verdict::legal);
      std::array<Corner, 2> unqueued;
      const Collapse done = mq::collapse(mesh, c, placement, worker, unqueued);
      CHECK(done.to == (is_held ? 7 : 0));
      CHECK(done.from == (is_held ? 0 : 7));
    }
}
