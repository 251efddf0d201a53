/// \file
/// Large meshes are drawn bit by bit, and the window goes on.
#include "Display.hh"
#include "meshes.hh"
#include "pictures.hh"

using namespace whittle;
using render::Image;
using viewing::difference;
using viewing::read_json;
using viewing::read_png;

TEST_CASE("what the window shows in the end is the whole picture, in however many pieces it was drawn") {
  const viewing::Display display;
  files::write_mesh(display.folder / "torus.ply", meshes::torus(60, 40));
  const auto at = [&](const std::string& name) { return "'" + display.folder / name + "'"; };
  std::string script =
      "wait\nmodule ivdd:distance=1.3e\nwait\nlayout split\nsplit 0.4\nplan on\nedges feature on\n";
  const std::vector<std::string> shadings{"smooth", "flat", "wires", "wires-over"};
  for (const std::string& shading : shadings)
    script += "shading " + shading + "\nheat " + (shading == "flat" ? "on" : "off") + "\nwait\ngrab " +
              at(shading + "-shown.png") + "\nscreenshot " + at(shading + "-whole.png") + "\n";
  const auto outcome =
      display.view(display.folder / "torus.ply", script + "close\n", {"--frame-budget", "0.01"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  for (const std::string& shading : shadings) {
    INFO(shading);
    const Image shown = read_png(display.folder / (shading + "-shown.png")),
                whole = read_png(display.folder / (shading + "-whole.png"));
    REQUIRE(shown.width == whole.width);
    REQUIRE(shown.height == whole.height);
    CHECK(viewing::colours(shown) > 100);
    CHECK(difference(shown, whole, 0, shown.width) == 0);
  }
}

TEST_CASE("a large mesh is sketched while it turns, and complete when it rests") {
  const viewing::Display display;
  files::write_mesh(display.folder / "torus.ply", meshes::torus(230, 110));
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  const auto outcome =
      display.view(display.folder / "torus.ply",
                   "layout original\nheat on\nmodule ivdd:distance=1.2e\nwait\nframe-times " +
                       at("opened.json") + "\ndrag left 0.4 0.5 0.6 0.6\nwait\nframe-times " +
                       at("turned.json") + "\ngrab " + at("shown.png") + "\nscreenshot " + at("whole.png") +
                       "\nkey ?\nkey Escape\nwait\nframe-times " + at("help.json") + "\nclose\n",
                   {"--frame-budget", "4"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(read_json(display.folder / "opened.json")["pictures"] > 0);
  const auto turned = read_json(display.folder / "turned.json");
  CHECK(turned["sketches"] > 0);
  CHECK(turned["pictures"] > 0);
  CHECK(turned["times"] > 10);
  const Image shown = read_png(display.folder / "shown.png");
  CHECK(difference(shown, read_png(display.folder / "whole.png"), 0, shown.width) == 0);
  // A dialog over the views is no reason to draw them again.
  const auto help = read_json(display.folder / "help.json");
  CHECK(help["sketches"] == 0);
  CHECK(help["pictures"] == 0);
}

TEST_CASE(
    "a picture that is asked for is drawn bit by bit, as it would be at once, and of what was seen then") {
  const viewing::Display display;
  files::write_mesh(display.folder / "torus.ply", meshes::torus(60, 40));
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  const auto outcome = display.view(
      display.folder / "torus.ply",
      "wait\nmodule ivdd:distance=1.3e\nheat on\nturn 20 10\nwait\npicture " + at("once.png") +
          " 480x360\nask-picture " + at("bits.png") + " 480x360\nturn 90 0\nshading wires\nwait\npicture " +
          at("later.png") + " 480x360\nask-picture /none/a.png 480x360\nwait\nexpect-error /none\nclose\n",
      {"--frame-budget", "0.01"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const Image once = read_png(display.folder / "once.png"), bits = read_png(display.folder / "bits.png");
  CHECK(difference(once, bits, 0, once.width) == 0);
  CHECK(difference(once, read_png(display.folder / "later.png"), 0, once.width) > 0.05);
}

TEST_CASE("a run that takes long has a bar, which is gone when it is done") {
  const viewing::Display display;
  files::write_mesh(display.folder / "torus.ply", meshes::torus(150, 100));
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  const auto outcome = display.view(
      display.folder / "torus.ply",
      "wait\nlive off\nmodule quadric:max-err=1\ntarget ratio 0.1\ndriver decimater\nlive on\nscreenshot " +
          at("busy.png") + "\nplaces " + at("busy.json") + "\nmodule vt\nwait\nplaces " + at("done.json") +
          "\nclose\n");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK_FALSE(read_json(display.folder / "done.json").contains("progress"));
  const auto busy = read_json(display.folder / "busy.json");
  REQUIRE(busy.contains("progress"));
  const auto number = [&](const char* key) { return busy["progress"][key].get<int>(); };
  const int left = number("x"), width = number("width"), y = number("y") + number("height") / 2;
  const Image image = read_png(display.folder / "busy.png");
  std::size_t dark = 0, blue = 0;
  for (int x = left + 3; x < left + width - 3; ++x) {
    const auto p = image.at(x, y);
    dark += p[0] < 45 && p[1] < 45 && p[2] < 50;
    blue += p[2] > 180 && p[2] > p[0] + 60;
  }
  CHECK(dark + blue > static_cast<std::size_t>(width) * 9 / 10);
}
