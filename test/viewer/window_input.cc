/// \file
/// Mouse and drag-and-drop input, as the X server sends it.
#include "Hand.hh"
#include "Running.hh"
#include "meshes.hh"
#include "model/Model.hh"
#include "model/RecipeText.hh"

using namespace whittle;
using viewing::read_json;

namespace {

/// Presses the mouse on a slider or histogram and drags it.
/// \param places  as the viewer has written them.
void pull(viewing::Hand& hand, const nlohmann::json& places, const std::string& name, double from,
          double to) {
  REQUIRE(places.contains(name));
  const auto& place = places[name];
  const auto number = [&](const char* key) { return place[key].get<int>(); };
  const int left = number("x"), top = number("y"), width = number("width"), height = number("height");
  hand.drag(left + static_cast<int>(from * width), top + height / 2, left + static_cast<int>(to * width),
            top + height / 2);
}

/// The value of a key of the first module, in mean edges if it is a length.
double value_in(const nlohmann::json& numbers, const std::string& key) {
  const recipe::Recipe recipe = viewer::parse_options(numbers["recipe"].get<std::string>());
  const auto number = recipe.modules.at(0).length(key, {1, 0});
  return number ? *number : recipe.modules.at(0).number(key).value_or(-1);
}

/// Where the edge lengths of a mesh and of what a recipe makes of it end in the histogram, in mean edges.
double end_of_edge_lengths(const std::string& mesh, const std::string& recipe) {
  const auto model = viewer::load_model(mesh);
  const auto outcome = viewer::make_outcome(model, viewer::parse_options(recipe));
  const viewer::Inspection result = viewer::inspect(outcome->mesh());
  return viewer::histograms(model->inspection, &result)[0].original.high / model->scale.mean_edge;
}

/// The mesh is what the command line makes of it with the recipe that the viewer has.
void check_result(const nlohmann::json& numbers, const std::string& mesh) {
  const auto result =
      recipe::run(files::read_mesh(mesh).mesh, viewer::parse_options(numbers["recipe"].get<std::string>()));
  CHECK(numbers["simplified"]["faces"] == result.mesh.triangles.size());
}

}  // namespace

TEST_CASE("a click on the histogram of edge lengths picks the threshold, one on the angles the angle") {
  const viewing::Display display;
  const std::string model = display.folder / "torus.ply";
  files::write_mesh(model, meshes::torus(60, 40));
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  const auto outcome = display.view(
      model,
      "wait\nresize 1200 900\nmodule fass:radius=0.8e\nwait\npull edge-length 0.5 0.5\nwait\nnumbers " +
          at("edge.json") + "\npull face-angle 0.25 0.25\nwait\nnumbers " + at("angle.json") +
          "\nundo\nundo\nwait\nnumbers " + at("undone.json") + "\nclose\n");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto edge = read_json(display.folder / "edge.json"), angle = read_json(display.folder / "angle.json");
  CHECK(value_in(edge, "radius") ==
        Approx(0.5 * end_of_edge_lengths(model, "fass:radius=0.8e")).epsilon(0.02));
  check_result(edge, model);
  CHECK(value_in(angle, "angle") == Approx(22.5).epsilon(0.02));
  CHECK(value_in(angle, "radius") == value_in(edge, "radius"));
  check_result(angle, model);
  CHECK(read_json(display.folder / "undone.json")["recipe"] == "--module fass:radius=0.8e");
}

TEST_CASE("the viewer takes slider, histogram and drag and drop from the X server's own events") {
  const viewing::Display display;
  viewing::Hand hand;
  const std::string model = display.folder / "torus.ply", other = display.folder / "small.off";
  files::write_mesh(model, meshes::torus(60, 40));
  files::write_mesh(other, meshes::torus(12, 8));
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  const auto touch = [&](const char* name) { files::write_file(display.folder / name, ""); };
  viewing::Running viewer(display, {model, "--size", "1200x800"},
                          "wait\nmodule ivdd:distance=0.5e\nwait\nplaces " + at("places.json") + "\nawait " +
                              at("pulled") + "\nwait\nnumbers " + at("slider.json") +
                              "\nundo\nwait\nnumbers " + at("undone.json") + "\nawait " + at("picked") +
                              "\nwait\nnumbers " + at("histogram.json") + "\nawait " + at("dropped") +
                              "\nwait\nnumbers " + at("drop.json") + "\nclose\n");

  const auto places = viewer.wait_for(display.folder / "places.json");
  pull(hand, places, "1.distance", 0.2, 0.5);
  touch("pulled");
  const auto slider = viewer.wait_for(display.folder / "slider.json");
  CHECK(value_in(slider, "distance") == Approx(2).epsilon(0.05));  // it ends at 4 mean edges
  check_result(slider, model);
  // The whole drag is one step back.
  CHECK(viewer.wait_for(display.folder / "undone.json")["recipe"] == "--module ivdd:distance=0.5e");

  pull(hand, places, "edge-length", 0.3, 0.6);
  touch("picked");
  const auto histogram = viewer.wait_for(display.folder / "histogram.json");
  // The axis may have moved while the mouse did, as it ends where the result's edges do.
  CHECK(value_in(histogram, "distance") > 0.5 * end_of_edge_lengths(model, "ivdd:distance=0"));
  check_result(histogram, model);

  hand.drop(other);
  touch("dropped");
  const auto drop = viewer.wait_for(display.folder / "drop.json");
  CHECK(drop["original"]["mesh"]["faces"] == 192);
  check_result(drop, other);
  CHECK(viewer.finish() == 0);
}

TEST_CASE("on a screen that is twice as fine everything is twice as large, and the mouse meets it") {
  const viewing::Display display;
  viewing::Hand hand;
  const std::string model = display.folder / "torus.ply", settings = display.folder / "viewer.json";
  files::write_mesh(model, meshes::torus(30, 20));
  const auto shot = [&](const std::string& name) {
    REQUIRE(programs::run(WHITTLE_VIEWER_PROGRAM,
                          {model, "--size", "800x600", "--screenshot", display.folder / name})
                .code == 0);
    return viewing::read_png(display.folder / name);
  };
  const auto plain = display.view(model, "wait\nplaces '" + display.folder / "plain.json" + "'\nclose\n");
  REQUIRE(plain.code == 0);
  CHECK(shot("plain.png").width == 800);

  hand.set_resources("Xft.dpi:\t192\n");
  CHECK(shot("fine.png").width == 1600);
  CHECK(viewing::read_png(display.folder / "fine.png").height == 1200);
  viewing::Running viewer(display, {model, "--size", "900x600"},
                          "wait\nmodule ivdd:distance=0.5e\nwait\nplaces '" + display.folder / "fine.json" +
                              "'\nawait '" + display.folder / "pulled" + "'\nwait\nnumbers '" +
                              display.folder / "numbers.json" + "'\nclose\n");
  const auto places = viewer.wait_for(display.folder / "fine.json");
  const auto once = read_json(display.folder / "plain.json");
  for (const char* name : {"edge-length", "quality"})
    for (const char* size : {"width", "height"}) {
      INFO(name << " " << size);
      CHECK(places[name][size].get<double>() == Approx(2 * once[name][size].get<double>()).epsilon(0.03));
    }
  pull(hand, places, "1.distance", 0.2, 0.5);
  files::write_file(display.folder / "pulled", "");
  CHECK(value_in(viewer.wait_for(display.folder / "numbers.json"), "distance") == Approx(2).epsilon(0.05));
  CHECK(viewer.finish() == 0);

  // The window opens at the size it had, not twice as large each time.
  files::write_file(settings, R"({"window_width": 700, "window_height": 500})");
  const std::string script = display.folder / "close.txt";
  files::write_file(script, "wait\nclose\n");
  REQUIRE(programs::run(WHITTLE_VIEWER_PROGRAM, {model, "--settings", settings, "--script", script}).code ==
          0);
  CHECK(read_json(settings)["window_width"] == 700);
  CHECK(read_json(settings)["window_height"] == 500);
}
