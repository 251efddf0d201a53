#include "whittle/planners/FaceAngle.hh"

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/plan/execute.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

CollapsePlan plan(const FaceAngle& planner, const IndexedMesh& mesh, std::vector<std::uint8_t> flags = {}) {
  flags.resize(mesh.points.size());
  return planner.plan(SurfaceT<double>(mesh, {std::move(flags), {}, {}}));
}

std::vector<std::uint32_t> removed(const CollapsePlan& plan) {
  std::vector<std::uint32_t> out;
  for (const Collapse& collapse : plan.collapses) out.push_back(collapse.from);
  return out;
}

FaceAngle at(double degrees) {
  FaceAngle planner;
  planner.max_normal_angle = degrees;
  return planner;
}

/// The largest angle between normals of a cone's faces, in degrees: of neighbours, and of any two.
double adjacent_angle(int n, double h) {
  const double z = std::cos(meshes::kPi / n),
               length = std::sqrt(z * z + h * h);  // normal = (h u, z) / length
  const double cosine = (z * z + h * h * std::cos(2 * meshes::kPi / n)) / (length * length);
  return std::acos(cosine) * 180 / meshes::kPi;
}
double opposite_angle(int n, double h) {
  return 2 * std::atan2(h, std::cos(meshes::kPi / n)) * 180 / meshes::kPi;
}

}  // namespace

TEST_CASE("FAD removes a vertex just inside of the threshold and keeps it just outside") {
  const IndexedMesh mesh = meshes::cone(6, 0.2);
  const double angle = adjacent_angle(6, 0.2);
  CHECK(removed(plan(at(angle + 1e-6), mesh)) == std::vector<std::uint32_t>{0});
  CHECK(plan(at(angle - 1e-6), mesh).collapses.empty());
}

TEST_CASE("FAD closes the hole with a fan and moves no vertex") {
  const IndexedMesh mesh = meshes::cone(6, 0.1);
  const auto out = execute(plan(at(30), mesh), mesh);
  CHECK(out.mesh.triangles.size() == 4);
  REQUIRE(out.mesh.points.size() == 6);
  for (std::size_t v = 0; v < 6; ++v) CHECK(out.mesh.points[v] == mesh.points[v + 1]);
}

TEST_CASE("FAD compares neighbouring faces, or every two") {
  const double h = 0.2, near = adjacent_angle(6, h), far = opposite_angle(6, h);
  REQUIRE(near < far);
  const IndexedMesh mesh = meshes::cone(6, h);
  FaceAngle planner = at((near + far) / 2);
  CHECK(plan(planner, mesh).collapses.size() == 1);
  planner.pairs = FaceAngle::Pairs::all;
  CHECK(plan(planner, mesh).collapses.empty());
  planner.max_normal_angle = far + 1e-6;
  CHECK(plan(planner, mesh).collapses.size() == 1);
}

TEST_CASE("FAD compares every two faces of a vertex of very many, too") {
  const double far = opposite_angle(100, 0.2);
  FaceAngle planner = at(far * 0.75);
  planner.pairs = FaceAngle::Pairs::all;
  CHECK(plan(planner, meshes::cone(100, 0.2)).collapses.empty());
  planner.max_normal_angle = far + 0.01;
  CHECK(removed(plan(planner, meshes::cone(100, 0.2))) == std::vector<std::uint32_t>{0});
}

TEST_CASE("FAD can ask for some of the angles only") {
  // A cone with one corner pulled down: the four edges next to it are sharper than the other two.
  IndexedMesh mesh = meshes::cone(6, 0.05);
  mesh.points[1].z() = -0.6;
  FaceAngle planner = at(10);
  CHECK(plan(planner, mesh).collapses.empty());
  planner.count = 3;
  CHECK(plan(planner, mesh).collapses.size() == 1);
  planner.count = 4;
  CHECK(plan(planner, mesh).collapses.empty());
}

TEST_CASE("FAD bounds the area of the star") {
  const IndexedMesh mesh = meshes::cone(6, 0);
  const double area = 6 * std::sqrt(3.0) / 4;
  FaceAngle planner = at(30);
  planner.max_area = area * (1 - 1e-9);
  CHECK(plan(planner, mesh).collapses.empty());
  planner.max_area = area * (1 + 1e-9);
  CHECK(plan(planner, mesh).collapses.size() == 1);
}

TEST_CASE("FAD with threshold 0 removes the vertices of a plane") {
  CHECK(plan(at(0), meshes::cone(7, 0)).collapses.size() == 1);
  CHECK(plan(at(0), meshes::cone(7, 1e-4)).collapses.empty());
}

TEST_CASE("FAD keeps boundary, locked, feature and complex vertices") {
  const IndexedMesh mesh = meshes::cone(6, 0);
  CHECK(plan(at(180), mesh, {kLocked}).collapses.empty());
  CHECK(plan(at(180), mesh, {kFeature}).collapses.empty());
  CHECK(removed(plan(at(180), mesh)) == std::vector<std::uint32_t>{0});  // and none of the boundary
  IndexedMesh complex = mesh;
  complex.points.emplace_back(0, 0, 1);
  complex.triangles.push_back({0, 1, 7});
  CHECK(plan(at(180), complex).collapses.empty());
}

TEST_CASE("FAD keeps a vertex with a degenerate face") {
  IndexedMesh mesh = meshes::cone(6, 0);
  mesh.points[0] = mesh.points[1];
  CHECK(plan(at(180), mesh).collapses.empty());
}

TEST_CASE("FAD's ring lock keeps the ring of a removed vertex, the strict lock keeps rings apart") {
  // Inner vertices of the flat 5 x 5 grid, scanned row by row. The first, 6, locks 7, 11 and 12 of them.
  const IndexedMesh mesh = meshes::flat_grid(5);
  FaceAngle planner = at(1);
  CHECK(removed(plan(planner, mesh)) == std::vector<std::uint32_t>{6, 8, 16, 18});
  planner.lock = FaceAngle::Lock::strict;
  CHECK(removed(plan(planner, mesh)) == std::vector<std::uint32_t>{6});
}

TEST_CASE("FAD starts the fan where the paper says") {
  IndexedMesh mesh = meshes::cone(5, 0);
  mesh.points[3] *= 0.4;  // pulled in: from here the worst triangle is best
  FaceAngle planner = at(30);
  REQUIRE(plan(planner, mesh).collapses.size() == 1);
  CHECK(plan(planner, mesh).collapses[0].to == 3);
  planner.apex = FaceAngle::Apex::lexicographic;
  CHECK(plan(planner, mesh).collapses[0].to == 1);  // the largest x
  mesh.points[2].x() = mesh.points[1].x();          // a tie in x: the largest y decides
  CHECK(plan(planner, mesh).collapses[0].to == 2);
}

TEST_CASE("FAD takes the next apex where the best one would flip a face, and says so") {
  // Around a dent, the fan from the lexicographic apex folds over; another one does not.
  IndexedMesh mesh = meshes::cone(5, 0);
  mesh.points[0] = {0.45, 0, 0};
  mesh.points[4] = {0.2, -0.1, 0};
  mesh.points[5] = {1.5, -3, 0};
  FaceAngle planner = at(30);
  planner.apex = FaceAngle::Apex::lexicographic;
  const CollapsePlan fallen = plan(planner, mesh);
  REQUIRE(fallen.collapses.size() == 1);
  CHECK(fallen.collapses[0].to != 5);
  CHECK(fallen.record.fell_back == 1);
  planner.guard.min_cos = -1;
  CHECK(plan(planner, mesh).collapses[0].to == 5);
}

TEST_CASE("FAD counts a vertex that no fan can replace as refused") {
  // The tip of a tetrahedron: its three faces are within 180 degrees, but one face would be left twice.
  const CollapsePlan result = plan(at(180), meshes::tetrahedron());
  CHECK(result.collapses.empty());
  CHECK(result.record.refused_by_link + result.record.refused_by_flip_guard == 4);
}

TEST_CASE("FAD refuses parameters that mean nothing") {
  const auto broken = [](auto change) {
    FaceAngle planner;
    change(planner);
    CHECK_THROWS_AS(planner.validate(), InvalidParameter);
    CHECK_THROWS_AS(plan(planner, meshes::tetrahedron()), InvalidParameter);
  };
  broken([](FaceAngle& p) { p.max_normal_angle = -1; });
  broken([](FaceAngle& p) { p.max_normal_angle = 180.5; });
  broken([](FaceAngle& p) { p.max_normal_angle = std::nan(""); });
  broken([](FaceAngle& p) { p.count = -1; });
  broken([](FaceAngle& p) { p.max_area = 0; });
  broken([](FaceAngle& p) { p.max_area = std::nan(""); });
  broken([](FaceAngle& p) { p.guard.min_cos = 1; });
}

TEST_CASE("FAD's threshold scales") {
  CHECK(at(30).scaled(0.5).max_normal_angle == 15);
}

TEST_CASE("FAD multiplies the angle by the tolerance of the vertex that goes, not of its ring") {
  const IndexedMesh mesh = meshes::cone(6, 0.2);
  const double angle = adjacent_angle(6, 0.2);
  const auto gone = [&](double degrees, float tip, float ring) {
    return removed(
        at(degrees).plan(SurfaceT<double>(mesh, {{}, {tip, ring, ring, ring, ring, ring, ring}, {}})));
  };
  const std::vector<std::uint32_t> tip{0}, none;
  CHECK(gone(180, 0, 1) == none);
  CHECK(gone(angle / 2 + 1e-6, 2, 1) == tip);
  CHECK(gone(angle / 2 - 1e-6, 2, 1) == none);
  CHECK(gone(angle / 2 + 1e-6, 1, 2) == none);
  CHECK(gone(2 * angle + 1e-5, 0.5, 1) == tip);
  CHECK(gone(2 * angle - 1e-5, 0.5, 1) == none);
  CHECK(gone(angle + 1e-6, 1, 0) == tip);
  CHECK(gone(100, 1000, 1) == tip);  // 180 degrees is enough for anything
  CHECK(gone(100, 3.6f, 1) == tip);
}

TEST_CASE("FAD removes a boundary vertex where the boundary is as flat as its faces, if it may") {
  // Of the flat 3 x 3 grid, 4 is inside and 1, 3, 5, 7 lie within the sides.
  const IndexedMesh mesh = meshes::flat_grid(3);
  FaceAngle planner = at(1);
  CHECK(removed(plan(planner, mesh)) == std::vector<std::uint32_t>{4});
  planner.boundary = Boundary::merge;
  const CollapsePlan result = plan(planner, mesh);
  REQUIRE(removed(result) == std::vector<std::uint32_t>{1, 3});  // their rings keep all others
  for (const Collapse& c : result.collapses) CHECK(c.faces == 1);
  CHECK(result.collapses[0].to == 2);  // the better fan of the two, 2 5 4 and 2 4 0
  CHECK(result.collapses[0].target == mesh.points[2]);
}

TEST_CASE("FAD bounds the turn of the boundary by the same angle") {
  // The corner 0 turns by 90 degrees. Removed first, it keeps 1, 3 and 4.
  FaceAngle planner = at(90 + 1e-9);
  planner.boundary = Boundary::merge;
  CHECK(removed(plan(planner, meshes::flat_grid(3))).front() == 0);
  planner.max_normal_angle = 90 - 1e-6;
  CHECK(removed(plan(planner, meshes::flat_grid(3))).front() == 1);
}

TEST_CASE("FAD starts the fan of a boundary vertex at a neighbour along the boundary") {
  for (const auto apex : {FaceAngle::Apex::delaunay, FaceAngle::Apex::lexicographic}) {
    IndexedMesh mesh = meshes::flat_grid(3);
    mesh.points[5].x() = 9;  // the lexicographically largest of the ring of 1, but inside of its fan
    FaceAngle planner = at(1);
    planner.apex = apex;
    planner.boundary = Boundary::merge;
    const CollapsePlan result =
        plan(planner, mesh, {kLocked, 0, kLocked, kLocked, kLocked, kLocked, kLocked, kLocked, kLocked});
    REQUIRE(removed(result) == std::vector<std::uint32_t>{1});
    CHECK(result.collapses[0].to == 2);
    CHECK(result.record.fell_back == 0);
  }
}

TEST_CASE("FAD leaves a mesh alone that has nothing to remove") {
  for (const Boundary boundary : {Boundary::keep, Boundary::merge}) {
    FaceAngle planner = at(180);
    planner.boundary = boundary;
    CHECK(plan(planner, {}).collapses.empty());
    CHECK(plan(planner, meshes::lone_triangle()).collapses.empty());
    CHECK(plan(planner, meshes::isolated_points(3)).collapses.empty());
  }
}

namespace {

/// The angles between the normals of the faces i and j, in degrees.
double angle_between(const IndexedMesh& mesh, std::size_t i, std::size_t j) {
  const SurfaceT<double> surface(mesh);
  const Eigen::Vector3d a = surface.normal(static_cast<std::uint32_t>(i)),
                        b = surface.normal(static_cast<std::uint32_t>(j));
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / meshes::kPi;
}

}  // namespace

TEST_CASE("FAD compares every pair of faces, wherever the ring begins") {
  // One corner of a cone is pulled down, so the edge to it is sharper than the others.
  IndexedMesh mesh = meshes::cone(6, 0.05);
  mesh.points[1].z() = -0.6;
  mesh = meshes::shaken(mesh, 0.02, 1);
  for (const auto pairs : {FaceAngle::Pairs::adjacent, FaceAngle::Pairs::all}) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i + 1; j < 6; ++j)
        if (pairs == FaceAngle::Pairs::all || j == i + 1 || (i == 0 && j == 5))
          angles.push_back(angle_between(mesh, i, j));
    std::sort(angles.rbegin(), angles.rend());
    REQUIRE(angles[0] > angles[1] + 1e-3);
    FaceAngle planner = at((angles[0] + angles[1]) / 2);
    planner.pairs = pairs;
    planner.guard.min_cos = -1;
    IndexedMesh turned = mesh;
    for (int i = 0; i < 6; ++i) {
      CHECK(plan(planner, turned).collapses.empty());
      std::rotate(turned.triangles.begin(), turned.triangles.begin() + 1, turned.triangles.end());
    }
    planner.max_normal_angle = angles[0] + 1e-6;
    CHECK(plan(planner, mesh).collapses.size() == 1);
    planner.max_normal_angle = (angles[0] + angles[1]) / 2;  // all but one qualify
    planner.count = static_cast<int>(angles.size()) - 1;
    CHECK(plan(planner, mesh).collapses.size() == 1);
  }
}

TEST_CASE("FAD's fan begins at the first of several vertices that are as good") {
  IndexedMesh mesh = meshes::cone(4, 0);
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (int i = 0; i < 4; ++i) {
    CHECK(plan(at(30), mesh).collapses[0].to == 1);
    std::rotate(mesh.triangles.begin(), mesh.triangles.begin() + 1, mesh.triangles.end());
  }
}

TEST_CASE("FAD's fan begins where the shape of the worst triangle is best, whatever its size") {
  // A kite: from 1 or 3 the fan has two equal triangles; from 2 or 4 a large slender one and a small one.
  IndexedMesh mesh = meshes::cone(4, 0);
  mesh.points = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}, {-0.5, 0, 0}, {0, -1, 0}};
  const auto quality = [&](std::size_t a, std::size_t b, std::size_t c) {
    return detail::triangle_quality(mesh.points[a], mesh.points[b], mesh.points[c]);
  };
  const double from_1 = std::min(quality(1, 2, 3), quality(1, 3, 4)),
               from_2 = std::min(quality(2, 3, 4), quality(2, 4, 1));
  REQUIRE(from_2 > 1.1 * from_1);
  CHECK(plan(at(30), mesh).collapses[0].to == 2);
}

TEST_CASE("FAD reports why the best fan was refused, not the last one") {
  // Over a dent: the best fan, from 3, folds a face over; nothing else is legal or keeps to the guard either.
  const CollapsePlan result = plan(at(180), meshes::tetrahedron());
  CHECK(result.record.refused_by_flip_guard + result.record.refused_by_link == 4);
  FaceAngle unguarded = at(180);
  unguarded.guard.min_cos = -1;
  CHECK(plan(unguarded, meshes::tetrahedron()).record.refused_by_link == 4);
}

TEST_CASE("FAD's fan of a boundary vertex starts at the better of its two ends") {
  // Around 1 lie 2 5 4 0; the fan from 2 has the triangles 2 5 4 and 2 4 0, that from 0 has 0 2 5 and 0 5 4.
  for (const std::uint32_t better : {2u, 0u}) {
    IndexedMesh mesh = meshes::flat_grid(3);
    if (better == 0) {
      mesh.points[4] = {0.05, 1, 0};
      mesh.points[5] = {1, 1, 0};
    }
    FaceAngle planner = at(1);
    planner.boundary = Boundary::merge;
    std::vector<std::uint8_t> flags(9, kLocked);
    flags[1] = 0;
    const CollapsePlan result = plan(planner, mesh, flags);
    REQUIRE(removed(result) == std::vector<std::uint32_t>{1});
    CHECK(result.collapses[0].to == better);
  }
}

TEST_CASE("FAD rates apexes all around a vertex of very many faces") {
  IndexedMesh disc = meshes::cone(
      512, 0);  // every second neighbour is rated; the one that is nearer than others is the best
  disc.points[385] *= 0.9;
  const CollapsePlan removed = FaceAngle().plan(SurfaceT<double>(disc));
  CHECK(meshes::merges(removed) == meshes::Merges{{0, 385}});
}
