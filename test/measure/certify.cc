#include "measure/certify.hh"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hh"
#include "measure/Distance.hh"
#include "meshes.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/triangle.hh"

using namespace whittle;
using namespace whittle::measure;

namespace {

IndexedMesh triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  IndexedMesh mesh;
  mesh.points = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// The unit square in n - 1 by n - 1 squares of two faces.
IndexedMesh flat_grid(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n * n; ++i)
    mesh.points.emplace_back(double(i % n) / (n - 1), double(i / n) / (n - 1), 0);
  for (std::uint32_t v = 0; v + n < n * n; ++v) {
    if (v % n == n - 1) continue;
    mesh.triangles.push_back({v, v + 1, v + n + 1});
    mesh.triangles.push_back({v, v + n + 1, v + n});
  }
  return mesh;
}

void add(IndexedMesh& mesh, const IndexedMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
  for (const auto& [a, b, c] : more.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
}

/// The bounds are no farther apart than asked and hold the distance, to the rounding of what is written here.
void check(const CertifiedDistance& d, double exact, double tolerance) {
  CHECK(d.upper - d.lower <= tolerance);
  CHECK(d.lower <= exact * (1 + 1e-12) + 1e-300);
  CHECK(d.upper >= exact * (1 - 1e-12));
}

IndexedMesh moved(IndexedMesh mesh, const Eigen::Vector3d& by) {
  for (auto& p : mesh.points) p += by;
  return mesh;
}

IndexedMesh scaled(IndexedMesh mesh, double by) {
  for (auto& p : mesh.points) p *= by;
  return mesh;
}

/// Brute force: the largest distance of the points of a fine grid on each face, and the spacing of the grid.
std::pair<double, double> by_grid(const IndexedMesh& from, const IndexedMesh& to, int n) {
  double largest = 0, spacing = 0;
  for (const auto& [a, b, c] : from.triangles) {
    const Eigen::Vector3d p = from.points[a], u = from.points[b] - p, v = from.points[c] - p;
    spacing = std::max({spacing, u.norm() / n, v.norm() / n, (u - v).norm() / n});
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Eigen::Vector3d q = p + (double(i) / n) * u + (double(j) / n) * v;
        double nearest = HUGE_VAL;
        for (const auto& [d, e, f] : to.triangles)
          nearest = std::min(nearest,
                             whittle::detail::squared_distance(q, to.points[d], to.points[e], to.points[f]));
        largest = std::max(largest, nearest);
      }
  }
  return {std::sqrt(largest), spacing};
}

}  // namespace

TEST_CASE("parallel planes are certified to be as far apart as they are, however they are cut into faces") {
  const IndexedMesh a = flat_grid(7), b = moved(flat_grid(4), {0, 0, 0.25});
  check(certify(a, b, 1e-3), 0.25, 1e-3);
  check(certify(b, a, 1e-3), 0.25, 1e-3);
  const IndexedMesh same = flat_grid(5);
  check(certify(a, same, 1e-2), 0, 1e-2);
  CHECK(certify(a, a, 1e-9).upper < 1e-12);
}

TEST_CASE("the certified distance of a tetrahedron over a face is its height") {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), tip(0.25, 0.25, 0.7);
  IndexedMesh tent;
  tent.points = {a, b, c, tip};
  tent.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const CertifiedDistance d = certify(tent, triangle(a, b, c), 1e-4);
  check(d, 0.7, 1e-4);
  CHECK(d.on_original);
  CHECK((d.farthest - tip).norm() < 1e-3);
}

TEST_CASE("the farthest point inside a face is found") {
  // From the middle of the large triangle both small ones, at two of its corners, are farther than from any corner.
  const IndexedMesh large = triangle({0, 0, 0}, {2, 0, 0}, {1, 0, 0.25});
  IndexedMesh small = triangle({0, 0, 0}, {0, 0.001, 0}, {0, 0, -0.001});
  add(small, triangle({2, 0, 0}, {2, 0.001, 0}, {2, 0, -0.001}));
  check(certify(large, small, 1e-5), std::hypot(1, 0.25), 1e-5);
}

TEST_CASE("a needle between samples is not missed") {
  IndexedMesh needle = flat_grid(4);
  add(needle, triangle({0.5, 0.5, 0}, {0.5 + 1e-7, 0.5, 0}, {0.5, 0.5, 0.3}));
  check(certify(needle, flat_grid(4), 1e-3), 0.3, 1e-3);
  // Without any area, too, in each order of its corners.
  for (const auto& [a, b, c] : {std::array{0, 0, 1}, std::array{0, 1, 0}, std::array{1, 0, 0}}) {
    const Eigen::Vector3d ends[] = {{0.5, 0.5, 0}, {0.5, 0.5, 0.3}};
    IndexedMesh spike = flat_grid(4);
    add(spike, triangle(ends[a], ends[b], ends[c]));
    check(certify(spike, flat_grid(4), 1e-3), 0.3, 1e-3);
    check(certify(spike, spike, 1e-3), 0, 1e-3);
    check(certify(triangle(ends[0], ends[1], ends[1]), triangle(ends[a], ends[b], ends[c]), 1e-3), 0, 1e-3);
  }
}

TEST_CASE("certified bounds hold what dense grids find on random soups") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto soup = [&](int n) {
    IndexedMesh mesh;
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector3d centre(number(random), number(random), number(random));
      const auto corner = [&] {
        return Eigen::Vector3d(centre +
                               0.4 * Eigen::Vector3d(number(random), number(random), number(random)));
      };
      add(mesh, triangle(corner(), corner(), corner()));
    }
    return mesh;
  };
  for (int round = 0; round < 12; ++round) {
    const IndexedMesh a = soup(1 + round), b = soup(12 - round);
    const CertifiedDistance d = certify(a, b, 1e-3);
    CHECK(d.upper - d.lower <= 1e-3);
    const auto [forward, of_a] = by_grid(a, b, 60);
    const auto [backward, of_b] = by_grid(b, a, 60);
    CHECK(d.upper >= std::max(forward, backward));
    CHECK(d.lower <= std::max(forward + of_a, backward + of_b));
  }
}

TEST_CASE("certified bounds hold for surfaces that are tiny, huge or far away") {
  const IndexedMesh a = flat_grid(3), b = moved(flat_grid(2), {0, 0, 0.25});
  for (const double size : {1e-300, 1e-30, 1e30, 1e300})
    check(certify(scaled(a, size), scaled(b, size), 1e-3 * size), 0.25 * size, 1e-3 * size);
  const Eigen::Vector3d away(1e9, -1e9, 0);
  check(certify(moved(a, away), moved(b, away), 1e-2), 0.25, 1e-2);
}

TEST_CASE("certified bounds of coincident faces") {
  IndexedMesh many;
  for (int i = 0; i < 500; ++i) add(many, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  check(certify(many, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1e-3), 0, 1e-3);
  check(certify(many, triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1}), 1e-3), 1, 1e-3);
}

TEST_CASE("certified bounds agree with samples, and do not depend on the threads") {
  const IndexedMesh a = torus(40, 20), b = torus(30, 16);
  const CertifiedDistance one = certify(a, b, 1e-3, 1);
  CHECK(one.upper >= distance(a, b, {50000, 2}).two_sided.max);
  for (const unsigned threads : {2u, 5u}) {
    const CertifiedDistance more = certify(a, b, 1e-3, threads);
    CHECK(more.lower == one.lower);
    CHECK(more.upper == one.upper);
    CHECK(more.farthest == one.farthest);
    CHECK(more.pieces == one.pieces);
  }
}

TEST_CASE("certify refuses what it cannot bound, and can be cancelled") {
  const IndexedMesh grid = flat_grid(3);
  CHECK_THROWS_AS(certify(grid, grid, 0), InvalidParameter);
  CHECK_THROWS_AS(certify(grid, grid, 1e-15), InvalidParameter);
  CHECK_THROWS_AS(certify(grid, grid, std::nan("")), InvalidParameter);
  CHECK_THROWS_AS(certify(grid, IndexedMesh(), 1e-3), InvalidMesh);
  IndexedMesh broken = grid;
  broken.points[0].x() = INFINITY;
  CHECK_THROWS_AS(certify(grid, broken, 1e-3), InvalidMesh);
  CHECK_THROWS_AS(certify(torus(40, 20), torus(30, 16), 1e-3, 2, [](double) { return false; }), Cancelled);
}
