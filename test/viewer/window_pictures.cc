/// \file
/// What the viewer shows.
#include <algorithm>
#include <cmath>

#include "Display.hh"
#include "meshes.hh"
#include "pictures.hh"
#include "render/heat_colour.hh"

using namespace whittle;
using render::Image;
using viewing::colours;
using viewing::difference;
using viewing::kBelowCaptions;
using viewing::read_png;

namespace {

constexpr int kWidth = 480, kHeight = 360;

/// A display with a torus, and pictures of it by script.
class Studio {
 public:
  Studio() : model_(display_.folder / "torus.ply") { files::write_mesh(model_, meshes::torus(60, 40)); }

  /// Runs a script in which `picture NAME` writes a picture of the views.
  void shoot(const std::string& script) {
    std::string whole = "wait\nmodule ivdd:distance=1.3e\nshading smooth\nwait\n";
    for (std::size_t at = 0; at < script.size();) {
      const std::size_t end = std::min(script.find('\n', at), script.size());
      const std::string line = script.substr(at, end - at);
      at = end + 1;
      whole += line.rfind("picture ", 0) == 0
                   ? "picture '" + display_.folder / (line.substr(8) + ".png") + "' " +
                         std::to_string(kWidth) + "x" + std::to_string(kHeight)
                   : line;
      whole += "\n";
    }
    const auto outcome = display_.view(model_, whole + "close\n");
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
  }
  Image picture(const std::string& name) const { return read_png(display_.folder / (name + ".png")); }

 private:
  viewing::Display display_;
  std::string model_;
};

double brightness(const Image& image, int x) {
  double sum = 0;
  for (int y = kBelowCaptions; y < image.height; ++y) {
    const auto p = image.at(x, y);
    sum += (p[0] + p[1] + p[2]) / 3.0;
  }
  return sum / (image.height - kBelowCaptions);
}

/// Whether a pixel is one of the heat colours, more or less in the shade.
bool is_heat(const std::array<std::uint8_t, 4>& pixel) {
  const Eigen::Vector3d seen(pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0);
  for (int i = 0; i <= 200; ++i) {
    const Eigen::Vector3d colour = render::heat_colour(i / 200.0).cast<double>();
    const double light = seen.dot(colour) / colour.squaredNorm();
    if (light > 0.55 && light < 1.05 && (seen - light * colour).norm() < 0.02) return true;
  }
  return false;
}

bool is_backdrop(const std::array<std::uint8_t, 4>& p) {
  return std::abs(p[0] - 64) < 3 && std::abs(p[1] - 68) < 3 && std::abs(p[2] - 74) < 3;
}

}  // namespace

TEST_CASE("the split line stands where it was put, the original left of it, the result right") {
  Studio studio;
  studio.shoot(
      "layout original\npicture before\nlayout result\npicture after\nlayout split\nsplit 0.3\npicture "
      "split");
  const Image before = studio.picture("before"), after = studio.picture("after"),
              split = studio.picture("split");
  CHECK(colours(before) > 50);
  CHECK(colours(after) > 50);
  CHECK(difference(before, after, 0, kWidth) > 0.005);
  const int line = static_cast<int>(std::lround(0.3 * kWidth));
  CHECK(std::max(brightness(split, line), brightness(split, line - 1)) > 200);
  CHECK(brightness(split, line - 20) < 180);
  CHECK(brightness(split, line + 20) < 180);
  CHECK(difference(split, before, 0, line - 14) == 0);
  CHECK(difference(split, after, line + 14, kWidth) == 0);
}

TEST_CASE("the split line follows the mouse, and so does the model") {
  Studio studio;
  studio.shoot(
      "layout split\npicture before\ndrag left 0.5 0.8 0.25 0.8\npicture dragged\n"
      "drag left 0.7 0.5 0.9 0.4\npicture turned\nkey F\npicture framed");
  const Image dragged = studio.picture("dragged");
  const int line = kWidth / 4;
  double brightest = 0;
  for (int x = line - 3; x <= line + 3; ++x) brightest = std::max(brightest, brightness(dragged, x));
  CHECK(brightest > 200);
  CHECK(difference(dragged, studio.picture("turned"), line + 20, kWidth) > 0.02);
  CHECK(difference(dragged, studio.picture("framed"), 0, kWidth) == 0);
}

TEST_CASE("the mouse wheel zooms the view") {
  Studio studio;
  studio.shoot("layout result\npicture before\nscroll 0.5 0.5 6\npicture near");
  const auto backdrop = [](const Image& image) {
    std::size_t n = 0;
    for (int y = kBelowCaptions; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) n += is_backdrop(image.at(x, y));
    return n;
  };
  CHECK(backdrop(studio.picture("near")) < backdrop(studio.picture("before")));
}

TEST_CASE("a heat map has heat colours alone, and more than one of them") {
  Studio studio;
  studio.shoot("layout result\nheat on\npicture heat\nheat-top 1000\npicture cold");
  for (const char* name : {"heat", "cold"}) {
    const Image image = studio.picture(name);
    std::size_t heat = 0, surface = 0, violet = 0;
    for (int y = kBelowCaptions; y < image.height; ++y)
      for (int x = kWidth / 2; x < image.width; ++x) {  // the legend stands on the left
        const auto p = image.at(x, y);
        if (is_backdrop(p)) continue;
        ++surface;
        heat += is_heat(p);
        violet += p[2] > p[1] + 30 && p[0] > p[1];
      }
    INFO(name << ": " << heat << " of " << surface);
    REQUIRE(surface > 5000);
    CHECK(static_cast<double>(heat) > 0.93 * static_cast<double>(surface));  // smoothed edges are mixtures
    if (std::string(name) == "cold")
      CHECK(static_cast<double>(violet) > 0.93 * static_cast<double>(surface));
    else
      CHECK(static_cast<double>(violet) < 0.9 * static_cast<double>(surface));
  }
}

TEST_CASE("every shading and every overlay changes the picture") {
  Studio studio;
  studio.shoot(
      "layout original\npicture smooth\nshading flat\npicture flat\nshading wires\npicture wires\n"
      "shading wires-over\npicture wires-over\nshading smooth\nedges feature on\nfeature-angle 5\n"
      "picture edges\nedges feature off\nplan on\nwait\npicture plan");
  const Image smooth = studio.picture("smooth");
  for (const char* name : {"flat", "wires", "wires-over", "edges", "plan"}) {
    INFO(name);
    const Image image = studio.picture(name);
    CHECK(difference(smooth, image, 0, kWidth) > 0.02);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
      if (image.rgba[i] != 255) FAIL("a pixel that one can see through");
  }
}

TEST_CASE("a picture has the size that was asked for, and the window that of the resize") {
  const viewing::Display display;
  files::write_mesh(display.folder / "torus.ply", meshes::torus(30, 20));
  const auto outcome =
      display.view(display.folder / "torus.ply", "wait\npicture '" + display.folder / "a.png" +
                                                     "' 333x222\nresize 700 500\nwait\n"
                                                     "screenshot '" +
                                                     display.folder / "b.png" + "'\nclose\n");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const Image a = read_png(display.folder / "a.png"), b = read_png(display.folder / "b.png");
  CHECK(a.width == 333);
  CHECK(a.height == 222);
  CHECK(b.width == 700);
  CHECK(b.height == 500);
  CHECK(colours(b) > 100);
}

TEST_CASE("a screenshot is one command") {
  const viewing::Display display;
  files::write_mesh(display.folder / "torus.ply", meshes::torus(30, 20));
  const auto outcome =
      programs::run(WHITTLE_VIEWER_PROGRAM, {display.folder / "torus.ply", "--recipe", "vt", "--size",
                                             "640x480", "--screenshot", display.folder / "shot.png"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(read_png(display.folder / "shot.png").width == 640);
  CHECK(colours(read_png(display.folder / "shot.png")) > 100);
}
