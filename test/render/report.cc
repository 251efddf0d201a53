#include "report/Report.hh"

#include <nlohmann/json.hpp>

#include "catch.hh"
#include "experiment/GeneratedMesh.hh"

using namespace whittle;
using nlohmann::json;

namespace {

/// Two sets with times made up.
struct Example {
  bench::Model model;
  bench::Settings settings;
  bench::Environment environment;
  std::vector<bench::SetResult> sets{2};

  Example() {
    model.kind = bench::ModelKind::generated;
    model.label = bench::kGeneratedLabel;
    model.mean_edge = 0.5;
    model.notes = {"a note | with a bar"};
    settings.width = 640;
    settings.height = 480;
    settings.repetitions = 2;
    environment.gl = {"llvmpipe", "Mesa", "4.5", "EGL device 0 (software)"};
    environment.cpu_model = "A Processor";
    environment.cpu_threads = 2;
    environment.compiler = "GNU 12";
    environment.build_type = "Release";
    environment.commit = "abc";
    environment.commit_dirty = true;
    environment.date_utc = "2024-01-02T03:04:05Z";
    sets[0].definition = bench::paper_sets()[0];
    sets[1].definition = bench::choose_sets({"fad-30"}).back();
    sets[0].facts.vertices = 500;
    sets[0].facts.faces = 1000;
    sets[1].facts.vertices = 375;
    sets[1].facts.faces = 750;
    sets[1].facts.nonmanifold_edges = 3;
    sets[1].flipped_faces = 4;
    sets[0].visits = {{1, {100, 90}}, {2, {200, 190}}};
    sets[1].visits = {{2, {80, std::nullopt}}, {1, {160, std::nullopt}}};
  }
  bench::Report report() const { return {model, settings, environment, sets}; }
};

}  // namespace

TEST_CASE("the JSON names every figure with its unit") {
  const Example example;
  const auto root = json::parse(bench::json_text(example.report()));
  CHECK(root["schema"] == "whittle-bench");
  CHECK(root["schema_version"] == 1);
  CHECK(root["date_utc"] == "2024-01-02T03:04:05Z");
  CHECK(root["model"] == json({{"label", "generated closed mesh, not the bunny"},
                               {"kind", "generated"},
                               {"file", nullptr},
                               {"vertices", 500},
                               {"triangles", 1000},
                               {"mean_edge_model_units", 0.5},
                               {"notes", {"a note | with a bar"}}}));
  CHECK(root["settings"] == json({{"image_width_px", 640},
                                  {"image_height_px", 480},
                                  {"frames_from", 100},
                                  {"frames_to", 1100},
                                  {"frames_timed", 1000},
                                  {"repetitions", 2}}));
  CHECK(root["environment"] == json({{"gl_renderer", "llvmpipe"},
                                     {"gl_vendor", "Mesa"},
                                     {"gl_version", "4.5"},
                                     {"egl_device", "EGL device 0 (software)"},
                                     {"cpu_model", "A Processor"},
                                     {"cpu_threads", 2},
                                     {"compiler", "GNU 12"},
                                     {"build_type", "Release"},
                                     {"git_commit", "abc"},
                                     {"git_dirty", true}}));
}

TEST_CASE("the JSON holds the raw times and what follows from them") {
  const Example example;
  const auto sets = json::parse(bench::json_text(example.report()))["sets"];
  REQUIRE(sets.size() == 2);
  const auto& set = sets[1];
  CHECK(set["name"] == "fad-30");
  CHECK(set["recipe"] == "fad:angle=30");
  CHECK(set["picture"] == "fad-30.png");
  CHECK(set["picture_ears"] == "fad-30-ears.png");
  CHECK(set["vertices"] == 375);
  CHECK(set["triangles"] == 750);
  CHECK(set["triangles_removed_percent"] == 25.0);
  CHECK(set["flipped_faces"] == 4);
  CHECK(set["nonmanifold_edges"] == 3);
  CHECK(set["wall_total_ms"] == json({{"median", 120.0}, {"min", 80.0}, {"max", 160.0}}));
  CHECK(set["gl_total_ms"].is_null());
  CHECK(set["frame_mean_ms"]["median"].get<double>() == Approx(0.12));
  CHECK(set["frames_per_second"]["max"].get<double>() == Approx(12500));
  CHECK(set["improvement_percent"]["median"].get<double>() == Approx(25));
  CHECK(set["frame_time_fall_percent"]["median"].get<double>() == Approx(20));
  const auto& second = set["repetitions"][1];
  CHECK(second["repetition"] == 2);
  CHECK(second["visited_as"] == 1);
  CHECK(second["wall_total_ms"] == 160.0);
  CHECK(second["gl_total_ms"].is_null());
  CHECK(second["improvement_percent"].get<double>() == Approx(25));
  CHECK(sets[0]["gl_total_ms"]["max"] == 190.0);
  CHECK(sets[0]["improvement_percent"]["median"] == 0.0);
}

TEST_CASE("the page has the machine, the table and the pictures, all with the model's label") {
  const Example example;
  const auto page = bench::markdown_text(example.report());
  CHECK_THAT(page, Catch::StartsWith("# Render benchmark: generated closed mesh, not the bunny\n"));
  CHECK_THAT(page, Catch::Contains("> **Note:** a note \\| with a bar\n"));
  CHECK_THAT(page, Catch::Contains("640x480 pixels"));
  CHECK_THAT(page, Catch::Contains("A Processor, 2 threads"));
  CHECK_THAT(page, Catch::Contains("commit abc with changes"));
  CHECK_THAT(page,
             Catch::Contains(
                 "| `fad:angle=30` | 375 | 750 | 25.0 | 4 | 3 | 120.0 (80.0 to 160.0) | none | 0.1200 |"));
  CHECK_THAT(page, Catch::Contains("| 25.0 (25.0 to 25.0) | 20.0 (20.0 to 20.0) |"));
  CHECK_THAT(page, Catch::Contains("![Original, generated closed mesh, not the bunny](original.png)"));
  CHECK_THAT(page, Catch::Contains("(fad-30-ears.png)"));
}

TEST_CASE("what the environment can find out is filled in") {
  const auto environment = bench::environment({"a", "b", "c", "d"});
  CHECK(environment.gl.renderer == "a");
  CHECK(environment.cpu_threads > 0);
  CHECK_FALSE(environment.cpu_model.empty());
  CHECK_FALSE(environment.compiler.empty());
  CHECK_FALSE(environment.build_type.empty());
  CHECK((environment.commit == "unknown" || environment.commit.size() == 40));
  CHECK(environment.date_utc.size() == 20);
}
