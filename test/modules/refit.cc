#include "whittle/refit.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "catch.hh"
#include "measure/Distance.hh"
#include "meshes.hh"
#include "whittle/bulk.hh"
#include "whittle/decimate.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/VertexDistance.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

/// Two hexagons around vertex 0, flat: 1..6 with a radius of 1/2, 7..12 with one of 1.
IndexedMesh flat_wheel() {
  IndexedMesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  for (const double radius : {0.5, 1.0})
    for (int i = 0; i < 6; ++i)
      mesh.points.emplace_back(radius * std::cos(i * 1.0471975511965976),
                               radius * std::sin(i * 1.0471975511965976), 0);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    mesh.triangles.push_back({0, 1 + i, 1 + next});
    mesh.triangles.push_back({1 + i, 7 + i, 7 + next});
    mesh.triangles.push_back({1 + i, 7 + next, 1 + next});
  }
  return mesh;
}

/// The wheel without the inner hexagon, which has merged into the centre; and that is off by so much.
ExecutedT<double> simplified_wheel(const IndexedMesh& wheel, const Eigen::Vector3d& off) {
  ExecutedT<double> out;
  out.mesh.points.push_back(off);
  out.vertex_map.assign(7, 0);
  for (std::uint32_t i = 0; i < 6; ++i) {
    out.mesh.points.push_back(wheel.points[7 + i]);
    out.vertex_map.push_back(1 + i);
    out.mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
    out.face_origin.push_back(3 * i);
  }
  return out;
}

template <typename Planner>
ExecutedT<double> decimated(const IndexedMesh& mesh, const Planner& planner) {
  BulkOptions options;
  options.refit = false;
  return bulk(planner, mesh, options);
}

MemorylessQuadric to_faces(std::size_t faces) {
  MemorylessQuadric planner;
  planner.target_faces = faces;
  return planner;
}

/// Of the vertices that a refit has moved, the least cosine between the move and the normal before it.
double least_along_normal(const IndexedMesh& plain, const IndexedMesh& fitted) {
  std::vector<Eigen::Vector3d> areas(plain.points.size(), Eigen::Vector3d::Zero());
  for (const auto& [a, b, c] : plain.triangles)
    for (const std::uint32_t v : {a, b, c})
      areas[v] += (plain.points[b] - plain.points[a]).cross(plain.points[c] - plain.points[a]);
  double least = 1;
  for (std::size_t v = 0; v < areas.size(); ++v)
    if (const Eigen::Vector3d move = fitted.points[v] - plain.points[v]; !move.isZero())
      least = std::min(least, std::abs(move.normalized().dot(areas[v].normalized())));
  return least;
}

double rms(const IndexedMesh& original, const IndexedMesh& mesh) {
  return measure::distance(original, mesh, {20000, 0}).two_sided.rms;
}

}  // namespace

TEST_CASE("a refit brings a vertex back to the plane that it has left, and moves nothing else") {
  const IndexedMesh wheel = flat_wheel();
  for (const double height : {0.05, -0.05}) {
    ExecutedT<double> result = simplified_wheel(wheel, {0, 0, height});
    const IndexedMesh before = result.mesh;
    const RefitReport report = refit(wheel, result);
    CHECK(std::abs(result.mesh.points[0].z()) < 0.05 * 0.05);
    CHECK(result.mesh.points[0].head<2>().norm() < 1e-3);
    CHECK(report.moved == 1);
    for (std::size_t v = 1; v < 7; ++v) CHECK(result.mesh.points[v] == before.points[v]);
    CHECK(result.mesh.triangles == before.triangles);
  }
}

TEST_CASE("a refit moves a vertex by a fifth of its shortest edge at most in a round") {
  const IndexedMesh wheel = flat_wheel();
  ExecutedT<double> result = simplified_wheel(wheel, {0, 0, 0.6});
  RefitOptions options;
  options.rounds = 1;
  refit(wheel, result, options);
  CHECK(result.mesh.points[0].z() == Approx(0.6 - 0.2 * std::sqrt(1.36)).epsilon(1e-3));
}

TEST_CASE("a refit keeps what the flags hold") {
  const IndexedMesh wheel = flat_wheel();
  for (const std::uint8_t flag : {kLocked, kFeature})
    for (const std::size_t v : {0u, 3u}) {  // the centre, and one that has merged with it
      ExecutedT<double> result = simplified_wheel(wheel, {0, 0, 0.05});
      RefitOptions options;
      options.flags.assign(wheel.points.size(), 0);
      options.flags[v] = flag;
      CHECK(refit(wheel, result, options).moved == 0);
      CHECK(result.mesh.points[0] == Eigen::Vector3d(0, 0, 0.05));
    }
}

TEST_CASE("a refit moves what lies on a seam along its normal only") {
  // The wheel on a slope, so that the normal is no axis; the centre is off along it and across it.
  IndexedMesh wheel = flat_wheel();
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 0.5).normalized());
  for (auto& p : wheel.points) p = turn * p;
  const Eigen::Vector3d across = turn * Eigen::Vector3d(0.1, 0.04, 0),
                        along = turn * Eigen::Vector3d(0, 0, 0.05);
  ExecutedT<double> result = simplified_wheel(wheel, across + along);
  RefitOptions options;
  options.flags.assign(wheel.points.size(), 0);
  options.flags[3] = kSeam;
  CHECK(refit(wheel, result, options).moved == 1);
  CHECK((result.mesh.points[0] - across).norm() < 0.01);
  options.flags[0] = kLocked;  // holds more
  result = simplified_wheel(wheel, across + along);
  CHECK(refit(wheel, result, options).moved == 0);
}

TEST_CASE("a refit turns no face over against what it was in the original") {
  // The faces of the original around the centre look down, those of the result up.
  IndexedMesh wheel = flat_wheel();
  ExecutedT<double> result = simplified_wheel(wheel, {0, 0, 0.05});
  for (std::size_t f = 0; f < wheel.triangles.size(); f += 3)
    std::swap(wheel.triangles[f][1], wheel.triangles[f][2]);
  const Eigen::Vector3d before = result.mesh.points[0];
  const RefitReport report = refit(wheel, result);
  CHECK(report.refused > 0);
  CHECK(result.mesh.points[0] == before);
}

TEST_CASE("a refit takes what lies on the other side of a thin sheet for no sample") {
  // A second wheel just below, turned over; the upper one's centre is off towards it and beyond.
  IndexedMesh both = flat_wheel();
  const IndexedMesh upper = both;
  for (const auto& p : upper.points) both.points.push_back(p - Eigen::Vector3d(0, 0, 0.02));
  for (const auto& t : upper.triangles) both.triangles.push_back({13 + t[0], 13 + t[2], 13 + t[1]});
  ExecutedT<double> result = simplified_wheel(upper, {0, 0, -0.05});
  result.vertex_map.insert(result.vertex_map.end(), 13, 0u);  // as if they had merged across
  refit(both, result);
  CHECK(std::abs(result.mesh.points[0].z()) < 0.003);
}

TEST_CASE("a refit brings decimated meshes closer to the original, and keeps what is sound sound") {
  for (const unsigned seed : {1u, 2u}) {
    const IndexedMesh torus = meshes::shaken(meshes::torus(96, 48), 0.002, seed);
    VertexDistance ivdd;
    ivdd.max_distance = 0.08;
    for (const ExecutedT<double>& result :
         {decimated(torus, to_faces(2000)), decimated(torus, to_faces(500)), decimated(torus, ivdd)}) {
      ExecutedT<double> fitted = result;
      const RefitReport report = refit(torus, fitted);
      CHECK(report.moved > result.mesh.points.size() / 2);
      CHECK(rms(torus, fitted.mesh) < 0.97 * rms(torus, result.mesh));
      CHECK(measure::distance(torus, fitted.mesh, {1000, 0}).flipped_faces == 0);
      CHECK(fitted.mesh.triangles == result.mesh.triangles);
    }
  }
}

TEST_CASE("a refit is the same on any number of threads, and in any place and size to rounding") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(128, 64), 0.002, 1);
  const ExecutedT<double> result = decimated(torus, to_faces(1500));
  RefitOptions options;
  options.threads = 1;
  ExecutedT<double> one = result;
  refit(torus, one, options);
  for (const std::size_t threads : {2u, 3u, 7u}) {
    ExecutedT<double> many = result;
    options.threads = threads;
    refit(torus, many, options);
    REQUIRE(many.mesh.points == one.mesh.points);
  }
  for (const double scale : {1e-20, 1e6}) {
    IndexedMesh large = torus;
    ExecutedT<double> moved = result;
    for (auto& p : large.points) p = scale * (p + Eigen::Vector3d(4, 0, -8));
    for (auto& p : moved.mesh.points) p = scale * (p + Eigen::Vector3d(4, 0, -8));
    refit(large, moved, options);
    for (std::size_t v = 0; v < one.mesh.points.size(); ++v)
      REQUIRE((moved.mesh.points[v] / scale - Eigen::Vector3d(4, 0, -8) - one.mesh.points[v]).norm() < 1e-3);
  }
}

TEST_CASE("a refit leaves finite what has faces without area, no faces, or nothing left of a piece") {
  IndexedMesh wheel = flat_wheel();
  ExecutedT<double> result = simplified_wheel(wheel, {0, 0, 0});
  for (auto& p : wheel.points) p.y() = 0;
  for (auto& p : result.mesh.points) p.y() = 0;
  refit(wheel, result);
  for (const auto& p : result.mesh.points) CHECK(p.allFinite());

  ExecutedT<double> none;
  none.vertex_map.assign(wheel.points.size(), std::numeric_limits<std::uint32_t>::max());
  CHECK(refit(wheel, none).moved == 0);
  CHECK(refit(IndexedMesh(), *std::make_unique<ExecutedT<double>>()).moved == 0);
}

TEST_CASE("a refit refuses maps and flags of another mesh, and no rounds") {
  const IndexedMesh wheel = flat_wheel();
  const ExecutedT<double> good = simplified_wheel(wheel, {0, 0, 0.05});
  const auto refused = [&](auto change, const RefitOptions& options = {}) {
    ExecutedT<double> result = good;
    change(result);
    CHECK_THROWS_AS(refit(wheel, result, options), InvalidParameter);
  };
  refused([](auto& result) { result.vertex_map.pop_back(); });
  refused([](auto& result) { result.face_origin.pop_back(); });
  refused([](auto& result) { result.face_origin[0] = 18; });
  RefitOptions options;
  options.rounds = 0;
  refused([](auto&) {}, options);
  options = {};
  options.flags.assign(5, 0);
  refused([](auto&) {}, options);
}

TEST_CASE("what mq makes of arrays is refitted unless told otherwise, or where it keeps a bound") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(48, 24), 0.002, 3);
  ExecutedT<double> by_hand = decimated(torus, to_faces(600));
  const std::vector<Eigen::Vector3d> plain = by_hand.mesh.points;
  const RefitReport report = refit(torus, by_hand);
  REQUIRE(report.moved > 0);
  const auto by_default = bulk(to_faces(600), torus);
  CHECK(by_default.mesh.points == by_hand.mesh.points);
  CHECK(by_default.refit.moved == report.moved);

  MemorylessQuadric bounded = to_faces(600);
  bounded.max_distance = 1;
  CHECK(bulk(bounded, torus).mesh.points == plain);
  BulkOptions asked;
  asked.refit = true;
  CHECK_THROWS_AS(bulk(bounded, torus, asked), InvalidParameter);

  VertexDistance ivdd;
  ivdd.max_distance = 0.08;
  CHECK(bulk(ivdd, torus).refit.moved == 0);
  CHECK(bulk(ivdd, torus, asked).refit.moved > 0);
}

TEST_CASE("arrays that are refitted keep what a tolerance of 0 holds, and seams their course") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(32, 16), 0.002, 3);
  SurfaceExtras extras;
  extras.tolerance.assign(torus.points.size(), 1);
  for (std::size_t v = 0; v < torus.points.size(); v += 5) extras.tolerance[v] = 0;
  extras.wedges = torus.triangles;  // a seam around faces 0..31
  for (std::size_t f = 0; f < 32; ++f)
    for (std::uint32_t& wedge : extras.wedges[f]) wedge += static_cast<std::uint32_t>(torus.points.size());
  BulkOptions options;
  options.extras = extras;
  options.refit = false;
  const auto plain = bulk(to_faces(500), torus, options);
  options.refit = true;
  const auto fitted = bulk(to_faces(500), torus, options);
  REQUIRE(fitted.refit.moved > 0);
  REQUIRE(fitted.vertex_map == plain.vertex_map);
  const std::vector<bool> on_seam = on_seams(torus.triangles, extras.wedges, torus.points.size());
  REQUIRE(std::count(on_seam.begin(), on_seam.end(), true) > 10);
  for (std::size_t v = 0; v < torus.points.size(); ++v) {
    const std::uint32_t now = plain.vertex_map[v];
    const Eigen::Vector3d move = fitted.mesh.points[now] - plain.mesh.points[now];
    if (extras.tolerance[v] == 0) CHECK(move == Eigen::Vector3d(0, 0, 0));
    if (!on_seam[v] || move.isZero()) continue;
    Eigen::Vector3d area(0, 0, 0);
    for (const auto& t : plain.mesh.triangles)
      if (t[0] == now || t[1] == now || t[2] == now)
        area += (plain.mesh.points[t[1]] - plain.mesh.points[t[0]])
                    .cross(plain.mesh.points[t[2]] - plain.mesh.points[t[0]]);
    CHECK(std::abs(move.normalized().dot(area.normalized())) >
          0.85);  // it turns a little from round to round
  }
}

TEST_CASE("where values count a refit moves vertices along their normals only") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(32, 16), 0.002, 3);
  const std::size_t n = torus.points.size();
  for (const bool values_count : {false, true}) {
    SurfaceExtras extras;
    if (values_count) {
      extras.n_values = 1;
      for (const auto& p : torus.points) extras.values.push_back(0.1f * static_cast<float>(p.x()));
    }
    const auto by_bulk = [&](bool refit) {
      BulkOptions options;
      options.extras = extras;
      options.refit = refit;
      return bulk(to_faces(500), torus, options).mesh;
    };
    const auto by_decimate = [&](bool refit) {
      DecimateOptions options;
      options.faces = 500;
      options.refit = refit;
      return decimate(torus, options, MemorylessQuadric(), extras).mesh;
    };
    const IndexedMesh plain = by_bulk(false), fitted = by_bulk(true);
    INFO(least_along_normal(plain, fitted));
    CHECK((least_along_normal(plain, fitted) > 0.85) == values_count);
    CHECK(by_decimate(false).points == plain.points);
    CHECK(by_decimate(true).points == fitted.points);

    extras.flags.assign(n, kSeam);  // stays where no wedge says how the seam runs
    CHECK(detail::refit_flags(torus, extras) == std::vector<std::uint8_t>(n, kSeam | kLocked));
    extras.wedges = torus.triangles;  // no seam, so all that the flags say
    CHECK(detail::refit_flags(torus, extras) == std::vector<std::uint8_t>(n, kSeam));
    extras.flags.clear();
    CHECK(detail::refit_flags(torus, extras) ==
          std::vector<std::uint8_t>(n, static_cast<std::uint8_t>(values_count ? kSeam : 0)));
  }
}

TEST_CASE("the steps of a refit's rounds become shorter, and their mean reciprocal is the same") {
  for (const std::size_t rounds : {1u, 2u, 5u}) {
    double sum = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
      const double step = refitting::step(round, rounds);
      CHECK(step > 1 / (0.644 + 0.268));
      CHECK(step < 1 / (0.644 - 0.268));
      if (round > 0) CHECK(step < refitting::step(round - 1, rounds));
      sum += 1 / step;
    }
    CHECK(sum / static_cast<double>(rounds) == Approx(0.644));
  }
}

TEST_CASE("a refit leaves what fits to rounding where it is, to the bit") {
  const IndexedMesh torus = meshes::torus(24, 12);
  ExecutedT<double> same;
  same.mesh = torus;
  for (std::uint32_t v = 0; v < torus.points.size(); ++v) same.vertex_map.push_back(v);
  for (std::uint32_t f = 0; f < torus.triangles.size(); ++f) same.face_origin.push_back(f);
  CHECK(refit(torus, same).moved == 0);
  CHECK(same.mesh.points == torus.points);
}
