#include "experiment/Experiment.hh"

#include <sstream>

#include "catch.hh"
#include "egl/EglContext.hh"
#include "experiment/GeneratedMesh.hh"

using namespace whittle;

TEST_CASE("the original is always among the chosen sets, and they keep the paper's order") {
  const auto all = bench::choose_sets({});
  CHECK(all.size() == 14);
  CHECK(all.front().recipe.empty());
  CHECK(bench::choose_sets({"vt", "all"}).size() == 14);

  const auto some = bench::choose_sets({"fass-0.0014-150", "ivdd-0.0011", "fad-30"});
  REQUIRE(some.size() == 4);
  CHECK(some[0].name == "original");
  CHECK(some[1].recipe == "fad:angle=30");
  CHECK(some[2].recipe == "ivdd:distance=0.0011");
  CHECK(some[3].recipe == "fass:radius=0.0014,angle=150");
  CHECK(bench::choose_sets({"original"}).size() == 1);
}

TEST_CASE("the fourteen sets of the paper have names of their own, which say the recipe") {
  for (const auto& set : bench::paper_sets()) {
    INFO(set.name);
    CHECK(bench::choose_sets({set.name}).back().name == set.name);
    // "fass-0.0012-30": the module, then its values in order.
    std::string values = set.recipe.substr(0, set.recipe.find(':'));
    for (auto equals = set.recipe.find('='); equals != std::string::npos;
         equals = set.recipe.find('=', equals + 1))
      values += "-" + set.recipe.substr(equals + 1, set.recipe.find(',', equals) - equals - 1);
    CHECK(values == (set.recipe.empty() ? "" : set.name));
  }
}

TEST_CASE("an unknown set is an error that lists those there are") {
  CHECK_THROWS_WITH(bench::choose_sets({"fad-31"}),
                    Catch::Contains("\"fad-31\"") && Catch::Contains("fad-30, "));
}

TEST_CASE("each repetition begins with another set and visits all") {
  CHECK(bench::visiting_order(3, 0) == std::vector<std::size_t>{0, 1, 2});
  CHECK(bench::visiting_order(3, 1) == std::vector<std::size_t>{1, 2, 0});
  CHECK(bench::visiting_order(3, 5) == std::vector<std::size_t>{2, 0, 1});
}

TEST_CASE("the original's mesh is left as it is") {
  const auto mesh = bench::generated_mesh(4);
  const auto set = bench::decimate(mesh, bench::paper_sets().front());
  CHECK(set.mesh.points == mesh.points);
  CHECK(set.mesh.triangles == mesh.triangles);
  CHECK(set.facts.faces == 320);
}

TEST_CASE("every set of the paper decimates the stand-in") {
  const auto mesh = bench::generated_mesh(20);
  for (const auto& definition : bench::choose_sets({})) {
    if (definition.recipe.empty()) continue;
    INFO(definition.name);
    const auto set = bench::decimate(mesh, definition);
    CHECK(set.facts.faces < mesh.triangles.size());
    CHECK(set.facts.faces > 0);
    CHECK(set.facts.closed());
    CHECK(set.flipped_faces == 0);
  }
}

TEST_CASE("all sets are timed in every repetition, in rotated order") {
  const egl::EglContext context;
  const render::Renderer renderer;
  const auto mesh = bench::generated_mesh(4);
  std::vector<bench::SetResult> sets(3);
  for (auto& set : sets) set.mesh = mesh;
  bench::Settings settings;
  settings.width = settings.height = 32;
  settings.frames = {1, 3};
  settings.repetitions = 2;
  std::ostringstream log;
  bench::Progress progress(log, bench::ProgressStyle::lines);
  const auto camera = bench::views(mesh, 1).whole;

  bench::time_sets(renderer, camera, settings, sets, progress, [] { return false; });
  const std::size_t places[3][2] = {{1, 3}, {2, 1}, {3, 2}};
  for (std::size_t i = 0; i < 3; ++i) {
    REQUIRE(sets[i].visits.size() == 2);
    for (std::size_t r = 0; r < 2; ++r) {
      CHECK(sets[i].visits[r].place == places[i][r]);
      CHECK(sets[i].visits[r].time.wall_ms > 0);
    }
  }
  CHECK(log.str().find("[6/6] repetition 2 of 2") != std::string::npos);

  CHECK_THROWS_AS(bench::time_sets(renderer, camera, settings, sets, progress, [] { return true; }),
                  bench::Stopped);
}

TEST_CASE("both pictures show the model, larger in the detail") {
  const egl::EglContext context;
  const render::Renderer renderer;
  const auto mesh = bench::generated_mesh(10);
  const auto pictures = bench::take_pictures(renderer, bench::views(mesh, 2), mesh, 64, 32);
  for (const auto* image : {&pictures.whole, &pictures.ears}) {
    CHECK(image->width == 64);
    CHECK(image->height == 32);
    CHECK(image->at(0, 0) != image->at(32, 20));
  }
  CHECK(pictures.whole.rgba != pictures.ears.rgba);
}
