#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "attributes/TextureError.hh"
#include "attributes/transfer.hh"
#include "catch.hh"
#include "charts.hh"
#include "measure/MeshFacts.hh"
#include "recipe/Recipe.hh"
#include "textured.hh"

using namespace whittle;
using namespace whittle::attributes;
using fixture::mq_down_to;
using fixture::run_with;
using fixture::textured;
using fixture::uv_at;

namespace {

/// x and y, moved to the right by ten times the chart.
Attribute moved_apart(const IndexedMesh& mesh, const std::vector<std::uint32_t>& chart) {
  return textured(mesh, [&](std::uint32_t f, const meshes::Point& p) {
    return Eigen::Vector2d(p.x() + 100 * chart[f], p.y());
  });
}

/// A box of six sides with n by n quads each, [0, 1] in each direction, and the side of each face.
IndexedMesh box(std::uint32_t n, std::vector<std::uint32_t>& side_of) {
  IndexedMesh mesh;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;
  for (std::uint32_t side = 0; side < 6; ++side) {
    const std::uint32_t axis = side / 2, far = side % 2;
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      std::array<std::uint32_t, 3> p{};
      p[axis] = far * n;
      p[(axis + 1) % 3] = far == 1 ? i : j;
      p[(axis + 2) % 3] = far == 1 ? j : i;
      const auto [found, is_new] = known.emplace(p, static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.emplace_back(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n);
      return found->second;
    };
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        side_of.insert(side_of.end(), 2, side);
      }
  }
  return mesh;
}

Eigen::Vector2d on_box(std::uint32_t side, const meshes::Point& p) {
  const int axis = static_cast<int>(side / 2);
  return {(p[(axis + 1) % 3] + side % 3) / 3, (p[(axis + 2) % 3] + side / 3) / 2};
}

IndexedMesh hills() {
  return meshes::grid(
      40, [](std::uint32_t i, std::uint32_t j) { return 2 * std::sin(i * 0.3) * std::cos(j * 0.2); });
}

/// x and y, moved a little to the right, by the chart: its border lies over the next one's by a hundredth at most.
Attribute nudged_apart(const IndexedMesh& mesh, const std::vector<std::uint32_t>& chart) {
  return textured(mesh, [&](std::uint32_t f, const meshes::Point& p) {
    return Eigen::Vector2d(p.x() + 0.001 * (chart[f] % 11), p.y());
  });
}

/// How many of the points of a fine grid lie in the texture in faces of more than one chart.
std::size_t points_of_several_charts(const Attribute& texture, const std::vector<std::uint32_t>& chart_of) {
  constexpr double kStep = 0.13;
  std::map<std::pair<int, int>, std::set<std::uint32_t>> charts;
  for (std::size_t f = 0; f < texture.corners.size(); ++f) {
    const auto& [ia, ib, ic] = texture.corners[f];
    const Eigen::Vector2d a = uv_at(texture, ia), b = uv_at(texture, ib), c = uv_at(texture, ic);
    const auto left_of = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& x) {
      return (q - p).x() * (x - p).y() - (q - p).y() * (x - p).x() > 1e-6;
    };
    const Eigen::Vector2d low = a.cwiseMin(b).cwiseMin(c) / kStep, high = a.cwiseMax(b).cwiseMax(c) / kStep;
    for (int i = static_cast<int>(low.x()); i <= high.x(); ++i)
      for (int j = static_cast<int>(low.y()); j <= high.y(); ++j) {
        const Eigen::Vector2d x(i * kStep, j * kStep);
        if (left_of(a, b, x) && left_of(b, c, x) && left_of(c, a, x)) charts[{i, j}].insert(chart_of[f]);
      }
  }
  return static_cast<std::size_t>(
      std::count_if(charts.begin(), charts.end(), [](const auto& entry) { return entry.second.size() > 1; }));
}

}  // namespace

TEST_CASE("a box in six charts comes to twelve faces with its texture as it was") {
  std::vector<std::uint32_t> side;
  const IndexedMesh mesh = box(16, side);
  const Attributes given{
      textured(mesh, [&](std::uint32_t f, const meshes::Point& p) { return on_box(side[f], p); })};
  const auto result = run_with(mesh, mq_down_to(12), given);
  REQUIRE(result.mesh.triangles.size() == 12);
  CHECK(result.target_reached);
  CHECK(result.held == 0);
  CHECK(result.charts == 6);
  CHECK(result.charts_gone == 0);
  for (std::size_t f = 0; f < 12; ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = result.mesh.points[result.mesh.triangles[f][k]];
      const Eigen::Vector2d is = uv_at(result.attributes[0], result.attributes[0].corners[f][k]);
      const meshes::Point corner(std::round(p.x()), std::round(p.y()), std::round(p.z()));
      CHECK((p - corner).norm() < 1e-4);
      CHECK((is - on_box(side[result.face_origin[f]], corner)).norm() < 1e-7);
    }
}

TEST_CASE("along a seam both sides have the values of one place") {
  const IndexedMesh mesh = hills();
  for (const std::size_t size : {60u, 400u}) {
    const auto chart = meshes::grown_charts(mesh, size, 2);
    const Attributes given{moved_apart(mesh, chart)};
    // Where a chart has vanished between two others, these have met nowhere.
    const auto result = run_with(mesh, mq_down_to(700, "mq:charts=keep"), given);
    CHECK(result.mesh.triangles.size() <= 700);
    CHECK(result.charts_gone == 0);
    const Attribute& out = result.attributes[0];
    std::map<std::uint32_t, std::map<std::uint32_t, std::set<std::uint32_t>>> at;  // vertex, chart, values
    for (std::size_t f = 0; f < out.corners.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        at[result.mesh.triangles[f][k]][chart[result.face_origin[f]]].insert(out.corners[f][k]);
    std::size_t compared = 0;
    for (const auto& [v, charts] : at) {
      if (charts.size() != 2 || charts.begin()->second.size() != 1 || charts.rbegin()->second.size() != 1)
        continue;
      const auto place = [&](const auto& entry) {
        return Eigen::Vector2d(uv_at(out, *entry.second.begin()) - Eigen::Vector2d(100 * entry.first, 0));
      };
      CHECK((place(*charts.begin()) - place(*charts.rbegin())).norm() < 1e-3);
      ++compared;
    }
    CHECK(compared > 10);
  }
}

TEST_CASE("values stay within their charts, also where charts vanish") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 24), 0.003, 1);
  for (const std::size_t size : {4u, 40u}) {
    const auto chart = meshes::grown_charts(mesh, size, 5);
    const Attributes given{moved_apart(mesh, chart)};
    const auto result = run_with(mesh, mq_down_to(200), given);
    CHECK(result.mesh.triangles.size() <= 200);
    CHECK(result.charts_gone > 0);
    CHECK(measure::facts(result.mesh).boundary_edges == 0);
    std::map<std::uint32_t, Eigen::AlignedBox2d> range;
    for (std::size_t f = 0; f < chart.size(); ++f)
      for (const std::uint32_t value : given[0].corners[f]) range[chart[f]].extend(uv_at(given[0], value));
    const Attribute& out = result.attributes[0];
    for (std::size_t f = 0; f < out.corners.size(); ++f)
      for (const std::uint32_t value : out.corners[f])
        CHECK(range[chart[result.face_origin[f]]].exteriorDistance(uv_at(out, value)) < 1e-4);
  }
}

TEST_CASE("no chart comes to lie over another in the texture more than before") {
  const IndexedMesh mesh = hills();
  for (const std::size_t size : {20u, 100u}) {
    const auto chart = meshes::grown_charts(mesh, size, 3);
    const Attributes given{nudged_apart(mesh, chart)};
    const std::size_t before = points_of_several_charts(given[0], chart);
    for (const std::size_t faces : {1000u, 300u}) {
      const auto result = run_with(mesh, mq_down_to(faces), given);
      std::vector<std::uint32_t> chart_after;
      for (const std::uint32_t f : result.face_origin) chart_after.push_back(chart[f]);
      // Where charts vanish their neighbours close over them: at most three of the 90,000 points in a thousand.
      CHECK(points_of_several_charts(result.attributes[0], chart_after) < before + 270);
    }
  }
}

TEST_CASE("charts that have changed places keep their own values") {
  const IndexedMesh mesh = meshes::flat_grid(13);
  const auto chart = meshes::halves(mesh, 6);
  const Attributes given{textured(mesh, [&](std::uint32_t f, const meshes::Point& p) {
    return Eigen::Vector2d(p.x() + (chart[f] == 0 ? 6 : -6), p.y());
  })};
  const auto result = run_with(mesh, mq_down_to(12), given);
  CHECK(result.mesh.triangles.size() <= 12);
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = result.mesh.points[result.mesh.triangles[f][k]];
      const Eigen::Vector2d is = uv_at(result.attributes[0], result.attributes[0].corners[f][k]);
      CHECK(is[0] == Approx(p.x() + (chart[result.face_origin[f]] == 0 ? 6 : -6)).margin(1e-4));
      CHECK(is[1] == Approx(p.y()).margin(1e-4));
    }
}

TEST_CASE("the two sides of a slit stay apart, and meet at its ends") {
  const IndexedMesh mesh = meshes::flat_grid(13);  // the slit from (6, 3) to (6, 9) opens to the right
  const Attributes given{textured(mesh, [&](std::uint32_t f, const meshes::Point& p) {
    const auto& t = mesh.triangles[f];
    const double middle = (mesh.points[t[0]].x() + mesh.points[t[1]].x() + mesh.points[t[2]].x()) / 3;
    const bool opens = p.x() == 6 && p.y() > 3 && p.y() < 9 && middle > 6;
    return Eigen::Vector2d(p.x() + (opens ? 0.5 : 0), p.y());
  })};
  const auto result = run_with(mesh, mq_down_to(20), given);
  CHECK(result.mesh.triangles.size() <= 20);
  CHECK(result.charts == 1);
  std::map<std::uint32_t, std::set<float>> across;  // first components at vertices on the slit
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = result.mesh.points[result.mesh.triangles[f][k]];
      if (std::abs(p.x() - 6) > 1e-4 || p.y() < 2.5 || p.y() > 9.5) continue;
      const auto uv = uv_at(result.attributes[0], result.attributes[0].corners[f][k]);
      across[result.mesh.triangles[f][k]].insert(static_cast<float>(uv[0]));
    }
  std::size_t open = 0, ends = 0;
  for (const auto& [v, values] : across) {
    const double y = result.mesh.points[v].y();
    const bool is_end = std::abs(y - 3) < 1e-4 || std::abs(y - 9) < 1e-4;
    ends += is_end && values.size() == 1;
    open += !is_end && values.size() == 2;
  }
  CHECK(ends == 2);
  CHECK(open >= 1);
}

TEST_CASE("values that are equal make no seam, whatever their numbers") {
  const IndexedMesh mesh = meshes::flat_grid(9);
  const Attributes given{
      textured(mesh, [](std::uint32_t, const meshes::Point& p) { return Eigen::Vector2d(p.x(), p.y()); })};
  const auto wedges = seam_wedges(given);
  REQUIRE(wedges.size() == mesh.triangles.size());
  std::map<std::uint32_t, std::set<std::uint32_t>> at;
  for (std::size_t f = 0; f < wedges.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) at[mesh.triangles[f][k]].insert(wedges[f][k]);
  for (const auto& [v, numbers] : at) CHECK(numbers.size() == 1);
  const auto result = run_with(mesh, mq_down_to(2), given);
  CHECK(result.mesh.triangles.size() == 2);
  CHECK(result.charts == 0);
}

TEST_CASE("several sets of texture coordinates have their seams each, and all move") {
  const IndexedMesh mesh = meshes::flat_grid(13);
  const auto by_x = meshes::halves(mesh, 4);
  const auto by_y =
      meshes::charts_by_centre(mesh, [](const meshes::Point& p) { return p.y() > 8 ? 1u : 0u; });
  const Attributes given{moved_apart(mesh, by_x), moved_apart(mesh, by_y)};
  const auto result = run_with(mesh, mq_down_to(20), given);
  CHECK(result.mesh.triangles.size() <= 20);
  CHECK(result.charts == 4);
  for (std::size_t set = 0; set < 2; ++set)
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const Attribute& out = result.attributes[set];
        const auto& p = result.mesh.points[result.mesh.triangles[f][k]];
        const auto& chart = set == 0 ? by_x : by_y;
        const double x = p.x() + 100 * chart[result.face_origin[f]];
        // Where both seams cross, mq's slight pull to the middle of an edge moves the vertex along the one off the other.
        CHECK((uv_at(out, out.corners[f][k]) - Eigen::Vector2d(x, p.y())).norm() < 1e-3);
      }
}

TEST_CASE("mq keeps every chart with charts=keep, and all drivers agree where seams move") {
  const IndexedMesh mesh = hills();
  const auto chart = meshes::grown_charts(mesh, 30, 2);
  const Attributes given{moved_apart(mesh, chart)};
  const auto kept = run_with(mesh, mq_down_to(500, "mq:charts=keep"), given);
  CHECK(kept.charts > 100);
  CHECK(kept.charts_gone == 0);
  const auto bulk = run_with(mesh, mq_down_to(500), given);
  CHECK(bulk.charts_gone > 0);
  for (const auto driver : {recipe::Driver::sweep, recipe::Driver::decimater}) {
    recipe::Recipe recipe = mq_down_to(500);
    recipe.driver = driver;
    const auto result = run_with(mesh, recipe, given);
    CHECK(meshes::canonical(result.mesh) == meshes::canonical(bulk.mesh));
    CHECK(result.charts_gone == bulk.charts_gone);
  }
}

TEST_CASE("a module that moves no seams leaves them where they are") {
  const IndexedMesh mesh = meshes::flat_grid(13);
  const auto chart = meshes::halves(mesh, 4);
  const Attributes given{moved_apart(mesh, chart)};
  const auto result = run_with(mesh, mq_down_to(60, "ss:radius=1.2e"), given);
  CHECK(result.held == 13);
  CHECK(result.held_on_seams == 13);
  const std::vector<std::string> why = recipe::reasons(mq_down_to(60, "ss:radius=1.2e"), result);
  CHECK(std::find(why.begin(), why.end(),
                  "13 vertices on seams stay in place, which seams=merge lets merge") != why.end());
  for (std::size_t v = 4; v < mesh.points.size(); v += 13)
    CHECK(result.mesh.points[result.vertex_map[v]] == mesh.points[v]);
}

TEST_CASE("the papers' modules merge along seams with seams=merge, in passes and down to a target") {
  const IndexedMesh mesh = hills();
  const auto chart = meshes::grown_charts(mesh, 200, 2);
  const Attributes given{moved_apart(mesh, chart)};
  for (const std::string spec : {"fad", "ivdd", "ss", "vtd", "fass"}) {
    INFO(spec);
    const auto held = run_with(mesh, mq_down_to(900, spec), given),
               merged = run_with(mesh, mq_down_to(900, spec + ":seams=merge"), given);
    CHECK(held.held > 100);
    CHECK(merged.held == 0);
    CHECK(merged.charts_gone == 0);
    CHECK(merged.mesh.triangles.size() < held.mesh.triangles.size() + 200);
    std::map<std::uint32_t, Eigen::AlignedBox2d> range;
    for (std::size_t f = 0; f < chart.size(); ++f)
      for (const std::uint32_t value : given[0].corners[f]) range[chart[f]].extend(uv_at(given[0], value));
    const Attribute& out = merged.attributes[0];
    for (std::size_t f = 0; f < out.corners.size(); ++f)
      for (const std::uint32_t value : out.corners[f])
        CHECK(range[chart[merged.face_origin[f]]].exteriorDistance(uv_at(out, value)) < 1e-4);
  }
}

TEST_CASE("the quadric merges along seams, and keeps every chart with charts=keep") {
  const IndexedMesh mesh = hills();
  const auto chart = meshes::grown_charts(mesh, 30, 2);
  const Attributes given{moved_apart(mesh, chart)};
  std::map<std::uint32_t, Eigen::AlignedBox2d> range;
  for (std::size_t f = 0; f < chart.size(); ++f)
    for (const std::uint32_t value : given[0].corners[f]) range[chart[f]].extend(uv_at(given[0], value));
  for (const bool keep : {false, true}) {
    const auto result = run_with(mesh, mq_down_to(500, keep ? "quadric:charts=keep" : "quadric"), given);
    CHECK(result.held == 0);
    CHECK(result.mesh.triangles.size() <= (keep ? 900 : 500));
    CHECK((result.charts_gone == 0) == keep);
    const Attribute& out = result.attributes[0];
    for (std::size_t f = 0; f < out.corners.size(); ++f)
      for (const std::uint32_t value : out.corners[f])
        CHECK(range[chart[result.face_origin[f]]].exteriorDistance(uv_at(out, value)) < 1e-4);
  }
}

TEST_CASE("after one stage the next moves the seams that are left") {
  const IndexedMesh mesh = hills();
  const Attributes given{moved_apart(mesh, meshes::grown_charts(mesh, 100, 2))};
  recipe::Recipe recipe = mq_down_to(300);
  recipe.modules.insert(recipe.modules.begin(), recipe::parse_spec("fad:angle=3"));
  const auto result = run_with(mesh, recipe, given);
  REQUIRE(result.stages.size() == 2);
  CHECK(result.stages[0].collapses > 0);
  CHECK(result.mesh.triangles.size() <= 300);
}

TEST_CASE("the texture error of a mesh against itself is nothing, and that of a shift is the shift") {
  const IndexedMesh mesh = meshes::flat_grid(9);
  const auto chart = meshes::halves(mesh, 4);
  const auto place = [&](double shift) {
    return textured(mesh, [&, shift](std::uint32_t f, const meshes::Point& p) {
      return Eigen::Vector2d(p.x() / 20 + 0.5 * chart[f] + shift, p.y() / 20);
    });
  };
  TextureErrorOptions options;
  options.samples = 5000;
  const TextureError none = texture_error(mesh, place(0), mesh, place(0), options);
  CHECK(none.rms < 1e-3);
  CHECK(none.max < 1e-3);
  CHECK(none.samples == 5000);
  CHECK(none.charts == 2);
  CHECK(none.charts_left == 2);
  const TextureError shifted = texture_error(mesh, place(0), mesh, place(2.0 / 1024), options);
  CHECK(shifted.rms == Approx(2).epsilon(1e-3));
  CHECK(shifted.max == Approx(2).epsilon(1e-3));
  options.texels = 512;
  CHECK(texture_error(mesh, place(0), mesh, place(2.0 / 1024), options).rms == Approx(1).epsilon(1e-3));
  options.threads = 3;
  CHECK(texture_error(mesh, place(0), mesh, place(2.0 / 1024), options).rms ==
        texture_error(mesh, place(0), mesh, place(2.0 / 1024), options).rms);

  Attribute turned = place(0);
  turned.downwards = true;
  for (std::size_t i = 1; i < turned.values.size(); i += 2) turned.values[i] = 1 - turned.values[i];
  CHECK(texture_error(mesh, place(0), mesh, turned, options).max < 1e-3);
  options.samples = 0;
  CHECK_THROWS_AS(texture_error(mesh, place(0), mesh, place(0), options), InvalidParameter);
}

TEST_CASE("the texture error leaves out charts that are gone") {
  const IndexedMesh mesh = meshes::flat_grid(9);
  const auto chart = meshes::halves(mesh, 4);
  const Attribute texture = textured(mesh, [&](std::uint32_t f, const meshes::Point& p) {
    return Eigen::Vector2d(p.x() / 20 + 0.5 * chart[f], p.y() / 20);
  });
  IndexedMesh half = mesh;
  Attribute of_half = texture;
  half.triangles.clear();
  of_half.corners.clear();
  for (std::size_t f = 0; f < chart.size(); ++f) {
    if (chart[f] == 1) continue;
    half.triangles.push_back(mesh.triangles[f]);
    of_half.corners.push_back(texture.corners[f]);
  }
  TextureErrorOptions options;
  options.samples = 4000;
  const TextureError error = texture_error(mesh, texture, half, of_half, options);
  CHECK(error.charts_left == 1);
  CHECK(error.samples == 2000);
  CHECK(error.max < 1e-3);
}

TEST_CASE("Seams: normals and colours that differ at corners make seams where asked") {
  // A plate of 11 x 11 quads, red on the left and blue on the right, and flat normals that differ in the same place.
  const IndexedMesh mesh = meshes::flat_grid(12);
  const std::vector<std::uint32_t> side =
      meshes::charts_by_centre(mesh, [](const meshes::Point& p) { return p.x() < 5 ? 0u : 1u; });
  Attribute colour{Kind::colour, "", 3, false, false, {1, 0, 0, 0, 0, 1}, {}};
  Attribute normal{Kind::normal, "", 3, false, false, {0, 0, 1, 0.6f, 0, 0.8f}, {}};
  for (const std::uint32_t s : side) {
    colour.corners.push_back({s, s, s});
    normal.corners.push_back({s, s, s});
  }
  for (const Attribute& attribute : {colour, normal}) {
    CHECK(seam_wedges({attribute}).empty());
    const SeamKinds kinds{attribute.kind == Kind::normal, attribute.kind == Kind::colour};
    CHECK(seam_wedges({attribute}, kinds).size() == mesh.triangles.size());
    recipe::Givens givens;
    const Attributes given = {attribute};
    givens.attributes = &given;
    givens.seams = kinds;
    const recipe::Result result = recipe::run(mesh, mq_down_to(8), {}, givens);
    CHECK(result.charts == 2);
    // The border is where it was, and its sides have their values.
    std::array<double, 2> before{}, after{};
    const auto add = [](const IndexedMesh& of, std::size_t f, double& area) {
      const auto& t = of.triangles[f];
      area += (of.points[t[1]] - of.points[t[0]]).cross(of.points[t[2]] - of.points[t[0]]).norm() / 2;
    };
    for (std::size_t f = 0; f < side.size(); ++f) add(mesh, f, before[side[f]]);
    const Attribute& now = result.attributes[0];
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
      const std::uint32_t s = now.value(now.corners[f][0])[0] == attribute.values[0] ? 0 : 1;
      add(result.mesh, f, after[s]);
      for (const std::uint32_t value : now.corners[f])
        CHECK(std::equal(now.value(value), now.value(value) + 3, attribute.value(s)));
    }
    CHECK(std::abs(after[0] - before[0]) < 1e-4 * before[0]);
    CHECK(std::abs(after[1] - before[1]) < 1e-4 * before[1]);
  }
}

TEST_CASE("where texture counts, a refit moves vertices along their normals only") {
  const IndexedMesh mesh = meshes::shaken(
      meshes::grid(31, [](auto i, auto j) { return 2 * std::sin(0.3 * i) * std::cos(0.3 * j); }), 0.05, 2);
  const Attributes given{moved_apart(mesh, std::vector<std::uint32_t>(mesh.triangles.size(), 0))};
  for (const std::string spec : {"mq", "mq:texture=0"}) {
    recipe::Recipe recipe = mq_down_to(400, spec);
    recipe.refit = false;
    const IndexedMesh plain = run_with(mesh, recipe, given).mesh;
    recipe.refit = true;
    const IndexedMesh fitted = run_with(mesh, recipe, given).mesh;
    REQUIRE(fitted.triangles == plain.triangles);
    std::vector<Eigen::Vector3d> areas(plain.points.size(), Eigen::Vector3d::Zero());
    for (const auto& [a, b, c] : plain.triangles)
      for (const std::uint32_t v : {a, b, c})
        areas[v] += (plain.points[b] - plain.points[a]).cross(plain.points[c] - plain.points[a]);
    double least = 1;
    for (std::size_t v = 0; v < areas.size(); ++v)
      if (const Eigen::Vector3d move = fitted.points[v] - plain.points[v]; move.norm() > 0)
        least = std::min(least, std::abs(move.normalized().dot(areas[v].normalized())));
    INFO(spec);
    CHECK((least > 0.8) == (spec == "mq"));
    CHECK(least < 1);
  }
}
