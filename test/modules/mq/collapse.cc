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
    values.set(v, own, {});
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
      for (const Corner c : {p, q, r}) values.add(mesh.table.vertex(c), term, 1);
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

/// Whether all quadrics, and what the values add to edges, are those of the faces that are left.
void check_quadrics(const mq::Mesh& mesh) {
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
    REQUIRE(difference(mesh.values.along(a, b, e, a), values.along(a, b, e, a)) < 1e-4f * most);
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
