#include "model/Settings.hh"

#include <cstdlib>

#include "../programs/Process.hh"
#include "catch.hh"
#include "files/MeshFile.hh"

using namespace whittle;
using namespace whittle::viewer;

TEST_CASE("settings are saved and loaded") {
  const programs::Folder folder;
  Settings settings;
  settings.remember("/a.obj");
  settings.remember("/b.obj");
  settings.remember("/a.obj");
  settings.width = 1000;
  settings.height = 700;
  settings.text_scale = 1.5;
  settings.mouse = MouseStyle::blender;
  settings.smooth_edges = false;
  settings.recipe = "--module vt";
  settings.view.layout = Layout::split;
  settings.view.shading = Shading::flat;
  settings.view.heat = true;
  settings.view.shows(EdgeSet::feature) = true;
  settings.view.feature_angle = 55;
  settings.view.orbit.set_up(Orbit::Up::z);
  save_settings(folder / "new/folder/viewer.json", settings);
  const Settings again = load_settings(folder / "new/folder/viewer.json");
  CHECK(again.recent == std::vector<std::string>{"/a.obj", "/b.obj"});
  CHECK(again.width == 1000);
  CHECK(again.height == 700);
  CHECK(again.text_scale == 1.5);
  CHECK(again.mouse == MouseStyle::blender);
  CHECK_FALSE(again.smooth_edges);
  CHECK(again.recipe == "--module vt");
  CHECK(again.view.layout == Layout::split);
  CHECK(again.view.shading == Shading::flat);
  CHECK(again.view.heat);
  CHECK(again.view.shows(EdgeSet::feature));
  CHECK_FALSE(again.view.shows(EdgeSet::boundary));
  CHECK(again.view.feature_angle == 55);
  CHECK(again.view.orbit.up() == Orbit::Up::z);
}

TEST_CASE("ten recent files are kept") {
  Settings settings;
  for (int i = 0; i < 15; ++i) settings.remember("/" + std::to_string(i));
  CHECK(settings.recent.size() == 10);
  CHECK(settings.recent.front() == "/14");
}

TEST_CASE("settings that are damaged, strange or missing do no harm") {
  const programs::Folder folder;
  CHECK(load_settings(folder / "none.json").width == Settings().width);
  for (const char* text :
       {"", "{", "[]", "3", R"({"window_width": "wide", "recent_files": 3, "view": [1]})",
        R"({"window_width": -5, "text_scale": 1e9, "view": {"layout": 7, "shading": "?"}})"}) {
    INFO(text);
    files::write_file(folder / "viewer.json", text);
    const Settings settings = load_settings(folder / "viewer.json");
    CHECK(settings.width >= 640);
    CHECK(settings.text_scale <= 4);
    CHECK(settings.view.layout == View().layout);
    CHECK(settings.recent.empty());
  }
}

TEST_CASE("settings are stored where XDG_CONFIG_HOME points") {
  setenv("XDG_CONFIG_HOME", "/x", 1);
  CHECK(settings_path() == "/x/whittle/viewer.json");
  unsetenv("XDG_CONFIG_HOME");
  setenv("HOME", "/h", 1);
  CHECK(settings_path() == "/h/.config/whittle/viewer.json");
}
