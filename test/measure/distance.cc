#include "measure/Distance.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/surface/errors.hh"

using namespace whittle;
using namespace whittle::measure;

namespace {

const DistanceOptions kQuick{20000, 2};

bool same(const Deviation& a, const Deviation& b) {
  return a.rms == b.rms && a.mean == b.mean && a.max == b.max && a.samples == b.samples;
}

}  // namespace

TEST_CASE("a mesh has no distance to itself and no flipped faces") {
  for (const IndexedMesh& mesh : {torus(40, 20), tetrahedron(), soup(5, 100), grid(10)}) {
    const Distance d = distance(mesh, mesh, kQuick);
    CHECK(d.two_sided.max <= 1e-12 * d.diagonal);
    CHECK(d.flipped_faces == 0);
  }
}

TEST_CASE("parallel squares are their height apart") {
  const Distance d = distance(square(0, 0), square(0, 0.25), kQuick);
  for (const Deviation& side : {d.forward, d.backward, d.two_sided}) {
    CHECK(side.rms == Approx(0.25).epsilon(1e-13));
    CHECK(side.mean == Approx(0.25).epsilon(1e-13));
    CHECK(side.max == 0.25);
  }
  CHECK(d.forward.samples == 20000);
  CHECK(d.two_sided.samples == 40000);
  CHECK(d.diagonal == Approx(std::sqrt(2.0)));
  CHECK(d.flipped_faces == 0);
}

TEST_CASE("the distance of a tent over a flat square is a third of its height on average") {
  const double height = 0.3;
  const Distance d = distance(tent(0), tent(height), kQuick);
  CHECK(d.backward.max == Approx(height).epsilon(1e-14));
  CHECK(d.backward.mean == Approx(height / 3).epsilon(3e-4));
  CHECK(d.backward.rms == Approx(height / std::sqrt(6.0)).epsilon(3e-4));
}

TEST_CASE("a spike of one vertex is met although no sample lies on its tip") {
  IndexedMesh spiked = grid(40);
  spiked.points[20 * 41 + 20].z() = 7;
  const Distance d = distance(grid(40), spiked, {100, 1});
  CHECK(d.backward.max == Approx(7).epsilon(1e-14));
  CHECK(d.two_sided.max == d.backward.max);
  CHECK(d.forward.max < 2);
}

TEST_CASE("a distance counts what one mesh lacks on that side only") {
  IndexedMesh two = square(0, 0);
  append(two, square(3, 0));
  const Distance d = distance(two, square(0, 0), kQuick);
  CHECK(d.backward.max <= 1e-15);
  CHECK(d.forward.max == 3);
  CHECK(d.forward.mean == Approx(1.25).epsilon(3e-4));
  CHECK(d.forward.rms == Approx(std::sqrt(19.0 / 6)).epsilon(3e-4));
  CHECK(d.two_sided.max == 3);
  CHECK(d.two_sided.mean == Approx(d.forward.mean / 2).epsilon(1e-14));
  CHECK(d.two_sided.rms == Approx(d.forward.rms / std::sqrt(2.0)).epsilon(1e-14));
}

TEST_CASE("samples are spread by area, not by face") {
  // A large and a finely cut small square: the small one must not draw the samples.
  IndexedMesh original = transformed(grid(30), 1.0 / 30, {0, 0, 1});
  append(original, transformed(square(0, 0), 3, {10, 0, 0}));
  IndexedMesh flat = transformed(square(0, 0), 1, {0, 0, 0});
  append(flat, transformed(square(0, 0), 3, {10, 0, 0}));
  CHECK(distance(original, flat, kQuick).forward.mean == Approx(0.1).epsilon(1e-3));
}

TEST_CASE("distances scale with the meshes and do not change when they are moved") {
  const IndexedMesh fine = torus(60, 30), coarse = torus(30, 15);
  const Distance unit = distance(fine, coarse, kQuick);
  CHECK(unit.two_sided.mean > 0.001);
  for (const double scale : {1e-6, 1e6}) {
    const Distance d =
        distance(transformed(fine, scale, {0, 0, 0}), transformed(coarse, scale, {0, 0, 0}), kQuick);
    CHECK(d.two_sided.rms == Approx(scale * unit.two_sided.rms).epsilon(1e-9));
    CHECK(d.two_sided.mean == Approx(scale * unit.two_sided.mean).epsilon(1e-9));
    CHECK(d.two_sided.max == Approx(scale * unit.two_sided.max).epsilon(1e-9));
    CHECK(d.flipped_faces == 0);
  }
  const Eigen::Vector3d away(1e4, 1e4, 1e4);
  const Distance moved = distance(transformed(fine, 1, away), transformed(coarse, 1, away), kQuick);
  CHECK(moved.two_sided.rms == Approx(unit.two_sided.rms).epsilon(1e-8));
  CHECK(moved.two_sided.max == Approx(unit.two_sided.max).epsilon(1e-8));
}

TEST_CASE("a distance by few samples comes close to one by many") {
  const IndexedMesh fine = torus(60, 30), coarse = torus(20, 10);
  const Distance few = distance(fine, coarse, {5000, 1}), many = distance(fine, coarse, {200000, 2});
  CHECK(few.two_sided.mean == Approx(many.two_sided.mean).epsilon(0.005));
  CHECK(few.two_sided.rms == Approx(many.two_sided.rms).epsilon(0.005));
}

TEST_CASE("the distance is the same to the bit on any number of threads") {
  const IndexedMesh original = torus(40, 20), simplified = torus(30, 15);
  const Distance one = distance(original, simplified, {20000, 1});
  for (const unsigned threads : {2u, 3u, 0u}) {
    const Distance d = distance(original, simplified, {20000, threads});
    CHECK(same(d.forward, one.forward));
    CHECK(same(d.backward, one.backward));
    CHECK(same(d.two_sided, one.two_sided));
    CHECK(d.flipped_faces == one.flipped_faces);
  }
}

TEST_CASE("a monitor sees the work go on to its end and changes nothing") {
  const IndexedMesh original = torus(60, 30), simplified = torus(30, 15);
  std::vector<double> parts;
  const Distance watched = distance(original, simplified, kQuick, [&](double part) {
    parts.push_back(part);
    return true;
  });
  REQUIRE(parts.size() > 20);
  CHECK(std::is_sorted(parts.begin(), parts.end()));
  CHECK(parts.front() < 0.1);
  CHECK(parts.back() == 1);
  const Distance alone = distance(original, simplified, kQuick);
  CHECK(same(watched.two_sided, alone.two_sided));
  CHECK(watched.flipped_faces == alone.flipped_faces);
}

TEST_CASE("a monitor ends a measurement wherever it is, and is not asked again") {
  const IndexedMesh original = torus(200, 100), simplified = torus(100, 50);
  std::size_t in_all = 0;
  distance(original, simplified, kQuick, [&](double) { return ++in_all > 0; });
  for (std::size_t patience = 0; patience < in_all * 9 / 10; patience += 1 + in_all / 12) {
    INFO(patience << " of " << in_all);
    std::size_t asked = 0;
    CHECK_THROWS_AS(distance(original, simplified, kQuick, [&](double) { return ++asked <= patience; }),
                    Cancelled);
    CHECK(asked == patience + 1);
  }
}

TEST_CASE("an inverted triangle is one flipped face") {
  IndexedMesh turned = torus(40, 20);
  std::swap(turned.triangles[77][0], turned.triangles[77][1]);
  CHECK(distance(torus(40, 20), turned, kQuick).flipped_faces == 1);
  CHECK(distance(square(0, 0), square(0, 0.1), kQuick).flipped_faces == 0);
}

TEST_CASE("at a sharp edge a face is not flipped that fits one of the two sides") {
  // A blade, its edge along x; a face just off the edge is equally near to both sides.
  const IndexedMesh blade{{{0, 0, 0}, {4, 0, 0}, {0, -4, 0.5}, {4, -4, 0.5}, {0, -4, -0.5}, {4, -4, -0.5}},
                          {{0, 2, 3}, {0, 3, 1}, {0, 5, 4}, {0, 1, 5}}};
  for (const bool up : {true, false}) {
    IndexedMesh off{{{1, 0.1, 0}, {2, 0.1, 0}, {1.5, 0.3, 0}}, {{0, 1, 2}}};
    if (!up) std::swap(off.triangles[0][0], off.triangles[0][1]);
    CHECK(distance(blade, off, {100, 1}).flipped_faces == 0);
  }
}

TEST_CASE("degenerate faces are left out on both sides") {
  IndexedMesh original = square(0, 0);
  original.points.insert(original.points.end(), {{50, 0, 0}, {51, 0, 0}, {52, 0, 0}});
  original.triangles.push_back({4, 5, 6});
  original.triangles.push_back({0, 0, 1});
  const Distance d = distance(original, square(0, 0), kQuick);
  CHECK(d.two_sided.max <= 1e-12);
  CHECK(distance(square(0, 0), original, kQuick).flipped_faces == 0);
}

TEST_CASE("the distance refuses a mesh without surface") {
  const IndexedMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  CHECK_THROWS_AS(distance({}, tetrahedron()), InvalidMesh);
  CHECK_THROWS_AS(distance(tetrahedron(), {}), InvalidMesh);
  CHECK_THROWS_AS(distance(tetrahedron(), line), InvalidMesh);
  CHECK_THROWS_AS(distance(tetrahedron(), tetrahedron(), {0, 1}), InvalidParameter);

  IndexedMesh unknown = tetrahedron();
  unknown.points[1].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(distance(tetrahedron(), unknown), InvalidMesh);
}
