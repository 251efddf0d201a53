/// \file
/// How polygons are cut into triangles.
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include "files/PolygonCutter.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

using Polygon = std::vector<IndexedMesh::Point>;
using Shape = PolygonCutter::Shape;

constexpr double kTau = 6.283185307179586;

double doubled_area(const Polygon& polygon, const IndexedMesh::Triangle& t) {
  const IndexedMesh::Point a = polygon[t[1]] - polygon[t[0]], b = polygon[t[2]] - polygon[t[0]];
  return a.x() * b.y() - a.y() * b.x();
}

/// Twice the area of a polygon in the plane of x and y.
double doubled_area(const Polygon& polygon) {
  double sum = 0;
  for (std::uint32_t i = 2; i < polygon.size(); ++i) sum += doubled_area(polygon, {0, i - 1, i});
  return sum;
}

/// Each side once, in its direction, and each other edge once in both: the triangles hang together as the polygon does.
bool has_the_sides(const Triangles& triangles, std::size_t corners) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const IndexedMesh::Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (std::uint32_t i = 0; i < corners; ++i) --edges[{i, (i + 1) % static_cast<std::uint32_t>(corners)}];
  for (const auto& [edge, count] : edges)
    if (count < 0 ||
        count != (edges.count({edge.second, edge.first}) ? edges.at({edge.second, edge.first}) : 0))
      return false;
  return true;
}

/// None lies on another one: as many triangles as corners minus two, none turned over, and the areas sum up.
void check_covered(const Polygon& polygon, PolygonCutter& cutter) {
  REQUIRE(cutter.triangles().size() == polygon.size() - 2);
  CHECK(has_the_sides(cutter.triangles(), polygon.size()));
  double sum = 0;
  for (const IndexedMesh::Triangle& t : cutter.triangles()) sum += std::abs(doubled_area(polygon, t));
  CHECK(sum == Approx(doubled_area(polygon)).epsilon(1e-9));
}

TEST_CASE("polygons: a convex one is the fan of its first corner") {
  PolygonCutter cutter;
  CHECK(cutter.cut({{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}) == Shape::convex);
  CHECK(cutter.triangles() == Triangles{{0, 1, 2}, {0, 2, 3}});
  Polygon round;
  for (int i = 0; i < 9; ++i)
    round.emplace_back(1e9 * std::sin(kTau * i / 9), 0, 1e9 * std::cos(kTau * i / 9));
  CHECK(cutter.cut(round) == Shape::convex);
  CHECK(cutter.triangles()[6] == IndexedMesh::Triangle{0, 7, 8});
}

TEST_CASE("polygons: a quadrilateral with a notch is cut along the diagonal inside of it") {
  PolygonCutter cutter;
  const Polygon dart{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
  CHECK(cutter.cut(dart) == Shape::concave);
  check_covered(dart, cutter);
  const Polygon turned{dart[1], dart[2], dart[3], dart[0]};
  CHECK(cutter.cut(turned) == Shape::concave);
  check_covered(turned, cutter);
}

TEST_CASE("polygons: corners on a straight line give no triangle without area") {
  PolygonCutter cutter;
  const Polygon square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                       {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  CHECK(cutter.cut(square) == Shape::concave);
  check_covered(square, cutter);
  for (const IndexedMesh::Triangle& t : cutter.triangles()) CHECK(doubled_area(square, t) > 0);
}

TEST_CASE("polygons: one with a bridge to a hole keeps the hole") {
  PolygonCutter cutter;
  // The square from 0 to 3 with the hole from 1 to 2; the bridge goes from the first corner, there and back.
  const Polygon frame{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                      {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  CHECK(cutter.cut(frame) == Shape::concave);
  check_covered(frame, cutter);
  // The same in a plane that leans.
  Polygon leaning = frame;
  for (IndexedMesh::Point& point : leaning)
    point = Eigen::AngleAxisd(0.7, IndexedMesh::Point(1, 2, 2) / 3) * point;
  CHECK(cutter.cut(leaning) == Shape::concave);
  CHECK(has_the_sides(cutter.triangles(), leaning.size()));
}

TEST_CASE("polygons: sides that cross are told, and no corner is lost") {
  PolygonCutter cutter;
  const Polygon bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  CHECK(cutter.cut(bow) == Shape::crossing);
  CHECK(has_the_sides(cutter.triangles(), 4));
  const Polygon uneven{{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}};
  CHECK(cutter.cut(uneven) == Shape::crossing);
  Polygon pentagram;  // all of its corners turn left
  for (int i = 0; i < 5; ++i)
    pentagram.emplace_back(std::cos(kTau * 2 * i / 5), std::sin(kTau * 2 * i / 5), 0);
  CHECK(cutter.cut(pentagram) == Shape::crossing);
  CHECK(has_the_sides(cutter.triangles(), 5));
}

TEST_CASE("polygons: what has no area is a fan") {
  PolygonCutter cutter;
  CHECK(cutter.cut({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}) == Shape::flat);
  CHECK(cutter.triangles() == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(cutter.cut(Polygon(5, {7, 7, 7})) == Shape::flat);
  CHECK(cutter.cut({{1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 0}, {0, -1e308, 0}}) == Shape::flat);
}

TEST_CASE("polygons: stars, combs and spirals of any size are covered once") {
  PolygonCutter cutter;
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int round = 0; round < 60; ++round) {
    Polygon star;
    const int corners = 5 + static_cast<int>(random() % 200);
    for (int i = 0; i < corners; ++i) {
      const double radius = 0.05 + uniform(), angle = kTau * i / corners;
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    cutter.cut(star);
    check_covered(star, cutter);
  }
  Polygon comb;
  for (int i = 0; i < 3000; ++i) comb.emplace_back(i % 2 == 0 ? i : i + 0.5, i % 2 == 0 ? 1 : 900, 0);
  comb.emplace_back(3000, 0, 0);
  comb.emplace_back(0, 0, 0);
  std::reverse(comb.begin(), comb.end());
  CHECK(cutter.cut(comb) == Shape::concave);
  check_covered(comb, cutter);
  Polygon spiral;
  for (int i = 0; i < 1000; ++i) spiral.emplace_back(i * std::cos(0.1 * i), i * std::sin(0.1 * i), 0);
  for (int i = 999; i >= 0; --i)
    spiral.emplace_back((i + 20) * std::cos(0.1 * i), (i + 20) * std::sin(0.1 * i), 0);
  std::reverse(spiral.begin(), spiral.end());
  CHECK(cutter.cut(spiral) == Shape::concave);
  check_covered(spiral, cutter);
}

TEST_CASE("polygons: one of many corners is covered once, or told to cross itself") {
  constexpr int turns = 20000;
  Polygon spiral;
  for (int i = 0; i < turns; ++i) spiral.emplace_back(i * std::cos(0.01 * i), i * std::sin(0.01 * i), 0);
  for (int i = turns - 1; i >= 0; --i)
    spiral.emplace_back((i + 200) * std::cos(0.01 * i), (i + 200) * std::sin(0.01 * i), 0);
  std::reverse(spiral.begin(), spiral.end());
  Polygon star;
  for (int i = 0; i < 5 * turns; ++i) {
    const double radius = i % 2 == 0 ? 1 : 0.3, angle = kTau * i / (5 * turns);
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (const Polygon& polygon : {spiral, star}) {
    PolygonCutter cutter;
    CHECK(cutter.cut(polygon) == Shape::concave);
    check_covered(polygon, cutter);
  }
  // Two sides of the spiral's outermost turn changed places, and two tips of the star.
  std::swap(spiral[100], spiral[101]);
  std::swap(star[6], star[8]);
  for (const Polygon& polygon : {spiral, star}) {
    PolygonCutter cutter;
    CHECK(cutter.cut(polygon) == Shape::crossing);
    CHECK(cutter.triangles().size() == polygon.size() - 2);
  }
}

TEST_CASE("polygons: all formats cut a concave face, with the values at its corners") {
  const Folder folder;
  const std::string places = "2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n";
  const auto check = [](const MeshFile& file) {
    CHECK(file.report.polygons == 1);
    CHECK(file.report.concave_polygons == 1);
    CHECK(file.report.notes() == Names{"1 face with more than three corners split into triangles",
                                       "1 of them is concave and cut by ear clipping"});
    double area = 0;
    for (const IndexedMesh::Triangle& t : file.mesh.triangles) {
      CHECK(doubled_area(file.mesh.points, t) > 0);
      area += doubled_area(file.mesh.points, t) / 2;
    }
    CHECK(area == 3);
  };
  check(folder.read("a.off", "OFF\n6 1 0\n" + places + "6 0 1 2 3 4 5\n"));
  check(folder.read(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
          places + "6 0 1 2 3 4 5\n"));
  const std::string vertices = "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n";
  check(folder.read("a.obj", vertices + "f 1 2 3 4 5 6\n"));
  // A face before its vertices waits for them, and another face keeps its place behind it.
  std::string texture;
  for (int i = 0; i < 6; ++i) texture += "vt 0." + std::to_string(i) + " 0\n";
  const MeshFile late = folder.read(
      "a.obj", texture + "f 1/1 2/2 3/3 4/4 5/5 6/6\nf 7 8 9\n" + vertices + "v 9 9 9\nv 9 8 9\nv 8 9 9\n");
  REQUIRE(late.mesh.triangles.size() == 5);
  CHECK(late.mesh.triangles[4] == IndexedMesh::Triangle{6, 7, 8});
  CHECK(late.report.concave_polygons == 1);
  const Attribute& values = find(late.attributes, Kind::texture);
  for (std::size_t face = 0; face < 4; ++face)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(values.value(values.at(late.mesh, face, k))[0] ==
            static_cast<float>(late.mesh.triangles[face][k]) / 10.0F);
}

}  // namespace
}  // namespace whittle::files
