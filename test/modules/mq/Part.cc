#include "whittle/mq/Part.hh"

#include <cmath>
#include <cstddef>

#include "mq/Built.hh"
#include "whittle/mq/Run.hh"

using namespace whittle;
using fixture::built;
using fixture::corner;
using meshes::IndexedMesh;
using mq::BucketQueue;
using mq::Corner;
using mq::Goal;
using mq::Part;

namespace {

constexpr Goal kFar{1000, 1000, 1000};

/// Queues an edge in a bucket, whatever it costs.
void put(mq::Mesh& mesh, Part& part, Corner c, std::size_t bucket) {
  mesh.table.notes(c).set_queued(c);
  part.push({c, static_cast<std::uint32_t>(bucket)});
}

/// Gives an edge of the grid a cost in the middle of a bucket, by planes that are alike at both ends.
void set_cost(mq::Mesh& mesh, Corner c, std::size_t bucket) {
  const std::uint32_t a = mesh.table.vertex(c), b = mesh.table.vertex(mq::next(c));
  mesh.quadrics[a] = mesh.quadrics[b] = mq::SymmetricMatrix::identity(1);
  float low = 1e-30f, high = 1e30f;
  while (high > 1.001f * low) {
    const float middle = std::sqrt(low) * std::sqrt(high);
    mesh.quadrics[a] = mesh.quadrics[b] = mq::SymmetricMatrix::identity(middle);
    const std::size_t is = BucketQueue::bucket_of(mq::place(mesh, {c, c, c, c})[0].cost);
    (is < bucket ? low : high) = middle;
  }
  mesh.quadrics[a] = mesh.quadrics[b] = mq::SymmetricMatrix::identity(1.05f * high);
  REQUIRE(BucketQueue::bucket_of(mq::place(mesh, {c, c, c, c})[0].cost) == bucket);
}

}  // namespace

TEST_CASE("mq's goal counts what vanishes, a vertex as two faces") {
  Goal goal{10, 3, 6};
  CHECK(goal.remaining() == 6);
  goal.count({0, 1, 2, 0, {}});
  CHECK(goal.remaining() == 4);
  goal.count({0, 1, 1, 0, {}});
  CHECK(goal.faces == 7);
  CHECK(goal.remaining() == 2);
  CHECK(Goal{3, 100, 3}.remaining() == 3);
}

TEST_CASE(
    "mq collapses an edge that has become dearer by up to two octaves, the less the nearer it is to its "
    "goal") {
  constexpr std::size_t kAt = 480;
  const auto is_collapsed = [&](std::size_t bucket, const Goal& goal) {
    mq::Mesh mesh = built(meshes::flat_grid(7));
    Part part(mesh, mq::kNoPart);
    const Corner c = corner(mesh, 24, 25);
    set_cost(mesh, c, bucket);
    put(mesh, part, c, kAt);
    part.work(kAt + 1, goal);
    if (part.done.empty()) CHECK(part.queue().size(bucket) == 1);  // for later
    return !part.done.empty();
  };
  CHECK(is_collapsed(kAt + 8, kFar));
  CHECK_FALSE(is_collapsed(kAt + 9, kFar));
  const Goal half{500, 1000, 1000};
  CHECK(is_collapsed(kAt + 4, half));
  CHECK_FALSE(is_collapsed(kAt + 5, half));
}

TEST_CASE("mq tries an illegal edge again four octaves later") {
  mq::Mesh mesh = built(meshes::flat_grid(3));
  Part part(mesh, mq::kNoPart);
  put(mesh, part, corner(mesh, 1, 5), 500);  // an inner edge between two boundary vertices
  part.work(501, kFar);
  CHECK(part.done.empty());
  CHECK(part.queue().next_bucket() == 516);
}

TEST_CASE("mq does no more than its goal asks for, though four edges are placed at once") {
  const IndexedMesh grid = meshes::flat_grid(13);
  mq::Mesh mesh = built(grid);
  Part part(mesh, mq::kNoPart);
  for (const std::uint32_t v : {28u, 35u, 119u, 126u}) put(mesh, part, corner(mesh, v, v + 1), 300);
  part.work(301, {2, 1000, 2});
  CHECK(part.done.size() == 1);
  part.work(301, {4, 1000, 4});
  CHECK(part.done.size() == 3);
}

TEST_CASE("mq places an edge anew once its surroundings have changed") {
  mq::Mesh mesh = built(meshes::flat_grid(9));
  Part part(mesh, mq::kNoPart);
  put(mesh, part, corner(mesh, 40, 41), 300);
  put(mesh, part, corner(mesh, 41, 42), 300);
  part.work(301, kFar);
  REQUIRE(part.done.size() == 2);
  CHECK(part.done[0].collapse.target.x() == Approx(4.5));
  CHECK(part.done[1].collapse.target.x() == Approx(5.25));
}

TEST_CASE("mq stops at the very number of faces or vertices") {
  const IndexedMesh torus = meshes::torus(12, 9);
  const auto left = [&](std::size_t faces, std::size_t vertices) {
    mq::Run run(torus, detail::checked(torus, {}), fixture::kUsual, 1);
    run.run(faces, vertices);
    return torus.points.size() - run.take().collapses.size();
  };
  CHECK(left(100, 0) == 50);
  CHECK(left(101, 0) == 50);
  CHECK(left(0, 50) == 50);
  CHECK(left(100, 60) == 60);
}
