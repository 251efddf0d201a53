#include "results/json.hh"

#include <nlohmann/json.hpp>

#include "catch.hh"
#include "example.hh"

using namespace whittle;
using nlohmann::json;

TEST_CASE("results read from their JSON are those written") {
  const auto results = example::results();
  const auto text = bench::json_text(results);
  CHECK(bench::json_text(bench::parse_results(text)) == text);
  const auto back = bench::parse_results(text);
  REQUIRE(back.experiments.size() == 2);
  const auto& set = back.experiments[0].sets[1];
  CHECK(set.definition.recipe == "vt");
  CHECK(set.visits[1].wall_ms == 100);
  CHECK(set.visits[1].gl_ms == 90.0);
  CHECK(set.fidelity->ssim_worst == 0.9);
  CHECK(set.pictures.heat == "pictures/heat.png");
  CHECK_FALSE(back.experiments[0].sets[2].visits[1].gl_ms);
  CHECK(back.experiments[1].sets[5].definition.role == bench::Role::cache);
}

TEST_CASE("the JSON names every figure with its unit, and gives the formed ones beside") {
  const auto root = json::parse(bench::json_text(example::results()));
  CHECK(root["schema"] == "whittle-bench");
  CHECK(root["schema_version"] == 2);
  CHECK(root["settings"] ==
        json({{"image_width_px", 640}, {"image_height_px", 480}, {"views", 6}, {"samples_per_side", 1000}}));
  const auto& set = root["experiments"][0]["sets"][2];
  CHECK(set["times"][1] == json({{"repetition", 2},
                                 {"start", 1},
                                 {"visited_as", 1},
                                 {"wall_total_ms", 160.0},
                                 {"gl_total_ms", nullptr}}));
  CHECK(set["figures"]["improvement_percent"] == json({{"median", 25.0}, {"min", 25.0}, {"max", 25.0}}));
  CHECK(set["figures"]["frame_time_fall_percent"]["median"].get<double>() == Approx(20));
  CHECK(set["figures"]["triangles_removed_percent"] == 25.0);
  CHECK(set["figures"]["certainty"] == "clear");
}

TEST_CASE("a JSON that is no results file is refused with the place of the error") {
  CHECK_THROWS_WITH(bench::parse_results(""), "not JSON, or cut off");
  CHECK_THROWS_WITH(bench::parse_results("{\"schema\": \"whittle-bench\""), "not JSON, or cut off");
  CHECK_THROWS_WITH(bench::parse_results("[]"), "the file is not an object");
  CHECK_THROWS_WITH(bench::parse_results("{\"schema\": \"other\"}"), Catch::Contains("whittle-bench"));

  const auto refused = [](const json::json_pointer& place, const json& value) {
    auto root = json::parse(bench::json_text(example::results()));
    root[place] = value;
    try {
      bench::parse_results(root.dump());
    } catch (const bench::ResultsError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using P = json::json_pointer;
  CHECK(refused(P("/schema_version"), 1) == "the file: schema version 1; this program reads version 2");
  CHECK(refused(P("/experiments/0/sets/1/times/0/wall_total_ms"), 0) ==
        "the file.experiments[0].sets[1].times[0]: wall_total_ms must be positive");
  CHECK(refused(P("/experiments/0/sets/1/triangles"), -1) ==
        "the file.experiments[0].sets[1].triangles is not a count");
  CHECK(refused(P("/experiments/0/sets/1/role"), "extra") ==
        "the file.experiments[0].sets[1]: unknown role \"extra\"");
  CHECK(refused(P("/experiments/1/sets"), json::array()) ==
        "the file.experiments[1]: the first set is not the original");
  CHECK(refused(P("/experiments/1/frames_to"), 100) ==
        "the file.experiments[1]: frames_to must be above frames_from");
  CHECK(refused(P("/notes"), "text") == "the file.notes has the wrong type");
  auto root = json::parse(bench::json_text(example::results()));
  root.erase("environment");
  CHECK_THROWS_WITH(bench::parse_results(root.dump()), "the file has no field \"environment\"");
}
