#include "speed/textured/suite.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "Folder.hh"
#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "measure/triangle.hh"
#include "speed/textured/atlas.hh"
#include "speed/textured/surfaces.hh"
#include "whittle/surface/charts.hh"

using namespace whittle;
using Catch::Matchers::Contains;

namespace {

Eigen::Vector2d place_of(const attributes::Attribute& texture, std::uint32_t value) {
  return {static_cast<double>(texture.value(value)[0]), static_cast<double>(texture.value(value)[1])};
}

double texture_area(const attributes::Attribute& texture, std::size_t face) {
  const auto& [a, b, c] = texture.corners[face];
  const Eigen::Vector2d p = place_of(texture, a), q = place_of(texture, b) - p, r = place_of(texture, c) - p;
  return (q.x() * r.y() - q.y() * r.x()) / 2;
}

/// The least and the largest area of a face in the texture, of its area in space.
std::pair<double, double> scales(const IndexedMesh& mesh, const attributes::Attribute& texture) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const double scale = texture_area(texture, f) / measure::corners(mesh, mesh.triangles[f]).area();
    least = std::min(least, scale);
    most = std::max(most, scale);
  }
  return {least, most};
}

/// Whether the charts are in the unit square and their boxes apart.
void check_apart(const Charts& all, const attributes::Attribute& texture) {
  std::vector<Eigen::AlignedBox2d> boxes(all.count);
  for (std::size_t f = 0; f < texture.corners.size(); ++f)
    for (const std::uint32_t value : texture.corners[f])
      boxes[all.of_face[f]].extend(place_of(texture, value));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(Eigen::AlignedBox2d(Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones()).contains(boxes[i]));
    for (std::size_t k = i + 1; k < boxes.size(); ++k) CHECK(boxes[i].intersection(boxes[k]).isEmpty());
  }
}

}  // namespace

TEST_CASE("the sphere of the textured suite is closed and has six charts") {
  const speed::Painted sphere = speed::sphere_in_six_charts(5);
  CHECK(sphere.mesh.triangles.size() == 300);
  const auto facts = measure::facts(sphere.mesh);
  CHECK(facts.closed());
  CHECK(facts.euler_characteristic == 2);
  CHECK(facts.volume > 3.9);
  CHECK(charts(sphere.mesh.triangles, sphere.paint.corners).count == 6);
  for (const auto& p : sphere.mesh.points) CHECK(p.norm() == Approx(1));
}

TEST_CASE("grown atlases have the charts that their published figures are about") {
  const IndexedMesh mesh = speed::sphere_in_six_charts(40).mesh;
  REQUIRE(mesh.triangles.size() == 19200);
  for (const auto& [size, count] : {std::pair{400u, 122u}, {100u, 371u}, {30u, 1196u}, {10u, 3210u}}) {
    const attributes::Attribute texture = speed::grown_atlas(mesh, size);
    CHECK(charts(mesh.triangles, texture.corners).count == count);
    for (const float x : texture.values) REQUIRE((x >= 0 && x <= 1));
  }
}

TEST_CASE("unwrapped atlases are in one scale, no chart over another, and no face is turned") {
  const IndexedMesh mesh = speed::sphere_in_six_charts(12).mesh;
  const attributes::Attribute unwrapped = speed::unwrapped_atlas(mesh, 60);
  const Charts all = charts(mesh.triangles, unwrapped.corners);
  CHECK(all.count >= 4);
  CHECK(all.count <= 40);
  const auto [least, most] = scales(mesh, unwrapped);
  CHECK(least > 0);
  CHECK(most < 100 * least);
  check_apart(all, unwrapped);

  // Of a cube: six, in which faces at the corners, whose normals are (1, 1, 1), are smallest by their cosine.
  const attributes::Attribute cubic = speed::cubic_atlas(mesh);
  const Charts six = charts(mesh.triangles, cubic.corners);
  CHECK(six.count == 6);
  const auto [smallest, largest] = scales(mesh, cubic);
  CHECK(smallest > 0.577 * largest);
  CHECK(smallest < 0.65 * largest);
  check_apart(six, cubic);
}

TEST_CASE("the textured suite measures its models and what others have made of them, and sets both out") {
  const scratch::Folder folder;
  speed::Painted sphere = speed::sphere_in_six_charts(10);
  const std::vector<speed::TexturedModel> models = {
      {"ball", speed::Half::tuning, sphere.mesh, {sphere.paint}}};
  speed::export_textured(models, folder / "peers/copy");
  std::filesystem::rename(folder / "peers/copy/ball.glb", folder / "peers/copy/ball-50.glb");
  std::ostringstream none;
  terminal::Progress progress(none, terminal::ProgressStyle::silent);
  speed::TexturedSettings settings;
  settings.rounds = 1;
  settings.samples = 500;
  settings.peers = folder / "peers";
  settings.pictures = folder / "pictures";
  const speed::Json suite = speed::run_textured(models, settings, progress);
  const speed::Json& results = suite.at("models")[0].at("results");
  REQUIRE(results.size() == 6);
  CHECK(results[0].at("contender") == "mq");
  CHECK(results[0].at("faces") <= 600);
  CHECK(results[0].at("topology_kept") == true);
  CHECK(results[0].at("texture_texels_of_1024").at("charts_left") == 6);
  CHECK(results[0].at("seconds").size() == 3);
  CHECK(results[1].at("contender") == "copy");
  CHECK(results[1].at("faces") == 1200);
  CHECK(results[1].at("texture_texels_of_1024").at("max").get<double>() < 0.01);
  CHECK(results[1].at("rms_ten_thousandths_of_diagonal").get<double>() < 0.01);
  std::ostringstream page;
  speed::write_textured(page, suite);
  CHECK_THAT(page.str(), Contains("### Models: tuning") && Contains("| ball | 10 | mq | ") &&
                             Contains("| ball | 50 | copy | 1200 | ") && Contains("6 of 6 | kept"));
}

TEST_CASE("the models of the textured suite are made where they are asked for") {
  const auto models = speed::textured_models("/nonexistent", {}, std::regex("^(sphere-6|soft-hills-disc)$"));
  REQUIRE(models.size() == 2);
  CHECK(models[0].attributes[0].kind == attributes::Kind::texture);
  CHECK(models[1].attributes[0].kind == attributes::Kind::colour);
  CHECK(models[1].mesh.triangles.size() == 19208);
}
