#include "measure/ClosestFace.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.hh"
#include "measure/Monitor.hh"
#include "measure/OrientedBoxes.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::measure;

namespace {

double distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - std::clamp(t, 0.0, 1.0) * (b - a)).norm();
}

/// Another way than the one under test: to the plane where the foot lies inside, else to the nearest side.
double distance_to_triangle(const Eigen::Vector3d& p, const Corners& t) {
  const Eigen::Vector3d n = t.normal().normalized();
  const auto left_of = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return n.dot((b - a).cross(p - a)) >= 0;
  };
  if (left_of(t.a, t.b) && left_of(t.b, t.c) && left_of(t.c, t.a)) return std::abs(n.dot(p - t.a));
  return std::min(
      {distance_to_segment(p, t.a, t.b), distance_to_segment(p, t.b, t.c), distance_to_segment(p, t.c, t.a)});
}

/// The distance to the nearest of all faces.
double search_all(const Eigen::Vector3d& p, const Surface& surface) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surface.size(); ++i)
    best = std::min(best, distance_to_triangle(p, surface.face(i)));
  return best;
}

void compare_with_all(const IndexedMesh& mesh, const std::vector<Eigen::Vector3d>& points, double size) {
  const Surface surface(mesh);
  const ClosestFace tree(surface, 1);
  for (const auto& point : points) {
    const auto answer = tree.closest(point);
    const double wanted = search_all(point, surface);
    REQUIRE(std::abs(std::sqrt(answer.squared_distance) - wanted) <= 1e-11 * size + 1e-13 * wanted);
    REQUIRE(std::abs(distance_to_triangle(point, surface.face(answer.face)) - wanted) <=
            1e-11 * size + 1e-13 * wanted);
  }
}

}  // namespace

TEST_CASE("the closest face is that of a search over all faces") {
  for (const unsigned seed : {1u, 2u}) {
    const IndexedMesh target = soup(seed, 200);
    std::vector<Eigen::Vector3d> points = transformed(soup(seed + 10, 120), 3, {-1, -1, -1}).points;
    const Surface surface(target);
    for (std::size_t i = 0; i < 200; ++i)
      points.push_back(surface.sample(i, 200));  // and points on the faces
    compare_with_all(target, points, 1);

    for (const double scale : {1e-6, 1e6}) {
      const IndexedMesh scaled_points = transformed({points, {}}, scale, {0, 0, 0});
      compare_with_all(transformed(target, scale, {0, 0, 0}), scaled_points.points, scale);
    }
    // Away from the origin a coordinate has fewer digits after the point, for the search over all as well.
    const Eigen::Vector3d away(1e4, -1e4, 1e4);
    compare_with_all(transformed(target, 1, away), transformed({points, {}}, 1, away).points, 10);
  }
}

TEST_CASE("faces closer together than single precision can tell are told apart") {
  IndexedMesh layers;
  for (int i = 0; i < 100; ++i) append(layers, square(0, 1 + 1e-8 * i));
  append(layers, square(0, 0));  // keeps the layers away from the centre, where floats are dense
  const Surface surface(layers);
  const ClosestFace tree(surface, 1);
  for (int i = 0; i < 100; ++i) {
    const auto answer = tree.closest({0.3, 0.4, 1 + 1e-8 * i + 2e-9});
    CHECK(answer.face / 2 == static_cast<std::size_t>(i));
  }
}

TEST_CASE("the closest face is found from points very far from the surface") {
  const IndexedMesh target = soup(7, 200);
  std::vector<Eigen::Vector3d> points;
  for (const double far : {1e3, 1e5, 1e6, 1e8, 1e30}) {
    points.emplace_back(far, 0, 0);
    points.emplace_back(-far, far, 0.5 * far);
  }
  compare_with_all(target, points, 1);
}

TEST_CASE("the closest of equally close faces is the first, and all of them are within the distance") {
  const IndexedMesh mesh = tent(1);
  const Surface surface(mesh);
  const ClosestFace tree(surface, 1);
  CHECK(tree.closest({0.5, 0.5, 3}).face == 0);
  CHECK(tree.within({0.5, 0.5, 3}, 2) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(tree.within({0.5, 0.5, 3}, 1.99).empty());
}

TEST_CASE("of faces that coincide the first is the closest, and all of them are within the distance") {
  IndexedMesh mesh = tent(1);  // four faces
  const auto own = mesh.triangles;
  for (const auto& t : own) mesh.triangles.push_back({t[1], t[2], t[0]});  // the same ones, begun elsewhere
  for (const auto& t : own) mesh.triangles.push_back({t[0], t[2], t[1]});  // turned over
  mesh.points.insert(mesh.points.end(),
                     {mesh.points[own[1][0]], mesh.points[own[1][1]], mesh.points[own[1][2]]});
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  mesh.triangles.push_back({n - 3, n - 2, n - 1});  // on vertices of its own
  const Surface surface(mesh);
  const ClosestFace tree(surface, 1);
  CHECK(tree.closest({0.5, 0.5, 3}).face == 0);
  CHECK(tree.within({0.5, 0.5, 3}, 2) == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  CHECK(tree.distinct_within({0.5, 0.5, 3}, 2) == std::vector<std::size_t>{0, 1, 2, 3, 8, 9, 10, 11});
}

TEST_CASE("the closest of thousands of faces around one vertex or one edge is that of a search over all") {
  constexpr std::uint32_t n = 1500;
  IndexedMesh fan, book;
  for (std::uint32_t i = 0; i < n; ++i)
    fan.points.emplace_back(std::cos(6.283185307179586 * i / n), std::sin(6.283185307179586 * i / n), 0);
  book.points = fan.points;
  IndexedMesh disc = fan;
  fan.points.emplace_back(0, 0, 0.5);
  disc.points.emplace_back(0, 0, 0);
  book.points.insert(book.points.end(), {{0, 0, -1}, {0, 0, 1}});
  for (std::uint32_t i = 0; i < n; ++i) {
    fan.triangles.push_back({n, i, (i + 1) % n});
    book.triangles.push_back({n, n + 1, i});
  }
  disc.triangles = fan.triangles;
  const std::vector<Eigen::Vector3d> somewhere = transformed(soup(5, 20), 2, {-1, -1, -1}).points;
  for (const IndexedMesh& mesh : {fan, book, disc}) {
    const Surface surface(mesh);
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < surface.size(); ++f) faces.push_back(f);
    REQUIRE(OrientedBoxes::mean_overlap(surface, faces) > 64);
    std::vector<Eigen::Vector3d> points = somewhere;
    for (std::size_t i = 0; i < 50; ++i) points.push_back(surface.sample(i, 50));
    compare_with_all(mesh, points, 1);
    const ClosestFace tree(surface, 1);
    CHECK(tree.closest(mesh.points[n]).face == 0);  // of all that are equally close the first
    CHECK(tree.within(mesh.points[n], 1e-9).size() == n);
    CHECK(tree.within(mesh.points[n], 9).size() == n);
  }
  const Surface surface(fan);
  CHECK_THROWS_AS(ClosestFace(surface, 1, [] { return false; }), Cancelled);
}

TEST_CASE("boxes along the axes hold a point as often as they overlap") {
  const IndexedMesh one = single_triangle();
  CHECK(OrientedBoxes::mean_overlap(Surface(one), {0}) == Approx(1));
  CHECK(OrientedBoxes::mean_overlap(Surface(one), {0, 0, 0}) == Approx(3));
  const IndexedMesh many = grid(16);  // each face fills its square, which is a little larger than it is
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < 512; ++f) faces.push_back(f);
  CHECK(OrientedBoxes::mean_overlap(Surface(many), faces) == Approx(2).epsilon(0.05));
}
