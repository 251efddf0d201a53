/// \file
/// A user's session: files, recipes, settings.
#include "Display.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;

TEST_CASE("a session in the window opens, changes, undoes, exports and takes a dropped file") {
  const viewing::Display display;
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  files::write_mesh(display.folder / "torus.ply", meshes::torus(40, 24));
  files::write_mesh(display.folder / "small.off", meshes::torus(12, 8));
  const auto outcome = display.view(
      "", "open " + at("torus.ply") + "\nwait\nmodule ivdd:distance=0.5e\nmodule ivdd:distance=1.3e\nwait\n" +
              "key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Y\nkey Ctrl+Shift+Z\nwait\nexport " + at("a.stl") +
              "\nexport " + at("a.obj") + "\nnumbers " + at("a.json") +
              "\nkey ?\nkey Escape\nkey S\nkey H\nkey P\nkey 2\nwait\n" + "drop " + at("small.off") +
              "\nwait\nnumbers " + at("b.json") + "\nclose\n");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto a = viewing::read_json(display.folder / "a.json"),
             b = viewing::read_json(display.folder / "b.json");
  CHECK(a["recipe"] == "--module ivdd:distance=1.3e");
  CHECK(a["original"]["mesh"]["faces"] == 1920);
  for (const char* name : {"a.stl", "a.obj"})
    CHECK(files::read_mesh(display.folder / name).mesh.triangles.size() == a["simplified"]["faces"]);
  CHECK(b["original"]["mesh"]["faces"] == 192);
  CHECK(b["recipe"] == a["recipe"]);
  CHECK(b["plan"]["faces_gone"] > 0);
}

TEST_CASE("the viewer restores settings, recent files and the recipe") {
  const viewing::Display display;
  const std::string settings = display.folder / "viewer.json";
  files::write_mesh(display.folder / "torus.ply", meshes::torus(20, 12));
  REQUIRE(display
              .view(display.folder / "torus.ply", "wait\nmodule vt\nlayout split\nheat on\nclose\n",
                    {"--settings", settings})
              .code == 0);
  const auto kept = viewing::read_json(settings);
  CHECK(kept["recent_files"][0] == display.folder / "torus.ply");
  CHECK(kept["view"]["layout"] == "split");
  REQUIRE(display
              .view(display.folder / "torus.ply",
                    "wait\nnumbers '" + display.folder / "n.json" + "'\nclose\n", {"--settings", settings})
              .code == 0);
  CHECK(viewing::read_json(display.folder / "n.json")["recipe"] == "--module vt");
  CHECK(viewing::read_json(settings)["view"]["heat"] == true);
}
