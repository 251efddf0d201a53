#include "speed/figures.hh"

#include <cmath>

#include "catch.hh"
#include "results/Statistics.hh"

using namespace whittle;
using speed::Json;

namespace {

Json result(const char* name, double median) {
  return {{"name", name}, {"seconds", {{"median", median}}}, {"score", nullptr}, {"memory", nullptr}};
}

Json scored(const char* name, double median, double mean_error, int nonmanifold_edges) {
  Json json = result(name, median);
  json["score"] = {{"nonmanifold_edges", nonmanifold_edges}, {"distance", {{"mean_units", mean_error}}}};
  return json;
}

Json with_memory(const char* name, double median, int loaded, int peak) {
  Json json = result(name, median);
  json["memory"] = {{"loaded_bytes", loaded}, {"peak_bytes", peak}};
  return json;
}

Json model(const char* name, int faces, const std::vector<Json>& results) {
  return {{"name", name}, {"faces", faces}, {"results", results}};
}

Json run(bool assertions, const char* suite, const std::vector<Json>& models) {
  return {{"openmesh_core", {{"assertions", assertions}, {"label", assertions ? "slow" : "fast"}}},
          {"suites", Json::array({{{"suite", suite}, {"models", models}}})}};
}

/// The only figure of a run.
speed::Figure only_figure(const Json& json) {
  const auto all = speed::figures(json);
  REQUIRE(all.size() == 1);
  return all.front();
}

}  // namespace

TEST_CASE("quantiles lie between the values") {
  CHECK(bench::quantile({3, 1, 2}, 0.5) == 2);
  CHECK(bench::quantile({4, 1, 2, 3}, 0.5) == 2.5);
  CHECK(bench::quantile({1, 2, 3, 4, 5}, 0.25) == 2);
  CHECK(bench::quantile({1, 2, 3, 4, 5}, 0.75) == 4);
  CHECK(bench::quantile({7}, 0.25) == 7);
  CHECK(bench::quantile({1, 2}, 1) == 2);
}

TEST_CASE("the sweep is held to the stock decimater, by the core that it ran on") {
  const std::vector<Json> models = {
      model("cow", 100, {result("sweep vt", 0.01), result("DecimaterT vt", 0.2), result("sweep ss", 0.01)})};
  const auto slow = only_figure(run(true, "figures", models));
  CHECK(slow.goal == 30);
  CHECK(slow.core == "slow");
  CHECK(slow.model == "cow");
  REQUIRE(slow.ratios.size() == 1);
  CHECK(slow.ratios[0].of == "vt");
  CHECK(slow.ratios[0].value == Approx(20));
  CHECK_FALSE(slow.reached());
  const auto fast = only_figure(run(false, "figures", models));
  CHECK(fast.goal == 10);
  CHECK(fast.reached());
}

TEST_CASE("the dragon asks more of the sweep than the bunny") {
  const std::vector<Json> results = {result("sweep fad", 0.5), result("meshopt_simplify as fad", 1)};
  const auto bunny = only_figure(run(true, "figures", {model("bunny", 9, results)}));
  CHECK(bunny.goal == 0.6);
  CHECK(bunny.ratios[0].value == Approx(0.5));
  CHECK(bunny.reached());
  CHECK_FALSE(only_figure(run(true, "figures", {model("dragon", 9, results)})).reached());
}

TEST_CASE("a fast bulk that breaks the manifold has not reached its goal") {
  const auto figure = [](int edges) {
    return only_figure(
        run(true, "figures",
            {model("cow", 9, {scored("bulk vt", 1, 0, edges), result("meshopt_simplifySloppy as vt", 2)})}));
  };
  CHECK(figure(0).reached());
  CHECK_FALSE(figure(3).reached());
  CHECK(figure(3).ratios[0].remark == "3 non-manifold edges");
}

TEST_CASE("a fast lazy decimater may not be worse by more than a hundredth") {
  const auto figure = [](double error) {
    return only_figure(run(
        true, "figures",
        {model("cow", 9,
               {scored("lazy quadric 50 %", 1, error, 0), scored("DecimaterT quadric 50 %", 15, 1, 0)})}));
  };
  CHECK(figure(1.009).reached());
  CHECK(figure(0.5).reached());
  CHECK_FALSE(figure(1.02).reached());
}

TEST_CASE("memory is the peak over what was loaded") {
  const auto all = speed::figures(
      run(true, "figures",
          {model("cow", 9, {with_memory("sweep vt", 1, 100, 150), with_memory("bulk vt", 1, 100, 260)})}));
  REQUIRE(all.size() == 2);
  CHECK(all[0].ratios[0].value == Approx(1.5));
  CHECK(all[0].reached());
  CHECK(all[1].ratios[0].value == Approx(2.6));
  CHECK_FALSE(all[1].reached());
}

TEST_CASE("growth is time per triangle against the first model") {
  const auto figure = only_figure(
      run(true, "growth",
          {model("calf", 100, {result("sweep vt", 1)}), model("cow", 400, {result("sweep vt", 8)})}));
  CHECK(figure.model == "cow");
  CHECK(figure.ratios[0].value == Approx(2));
  CHECK_FALSE(figure.reached());
}

TEST_CASE("figures need times") {
  CHECK(speed::figures(run(true, "figures", {model("cow", 9, {result("sweep vt", 1)})})).empty());
  Json untimed = result("DecimaterT vt", 1);
  untimed["seconds"] = nullptr;
  CHECK(speed::figures(run(true, "figures", {model("cow", 9, {result("sweep vt", 1), untimed})})).empty());
}

TEST_CASE("mq is held to the peers in time and in error") {
  const auto scored = [](const char* name, double seconds, double rms) {
    Json json = result(name, seconds);
    json["score"]["distance"] = {{"mean_units", 1.0}, {"rms_percent_of_diagonal", rms}};
    return json;
  };
  const auto all = speed::figures(
      run(true, "figures",
          {model("cow", 100,
                 {scored("bulk mq 10 %", 0.3, 0.02), scored("meshopt_simplify 10 %", 0.2, 0.04),
                  scored("CGAL Lindstrom-Turk 10 %", 9, 0.02)})}));
  REQUIRE(all.size() == 3);
  CHECK(all[0].ratios.at(0).value == Approx(1.5));
  CHECK_FALSE(all[0].reached());
  CHECK(all[1].against == "CGAL Lindstrom-Turk");
  CHECK(all[1].ratios.at(0).value == Approx(1));
  CHECK(all[1].reached());
  CHECK(all[2].ratios.at(0).value == Approx(0.5));
}

TEST_CASE("over several models errors count as ratios, where the faces are as many, and down to rounding") {
  const auto at = [](const char* name, int faces, double rms, double max) {
    Json json = result(name, 0.01);
    json["score"] = {{"faces", faces},
                     {"nonmanifold_edges", 0},
                     {"distance", {{"rms_percent_of_diagonal", rms}, {"max_percent_of_diagonal", max}}}};
    return json;
  };
  const auto pair = [&](const char* name, double rms, double theirs, int their_faces) {
    return model(name, 100,
                 {at("bulk mq 50 %", 50, rms, 1), at("meshopt_simplify 50 %", their_faces, theirs, 2)});
  };
  const auto means = [&](const std::vector<Json>& models) {
    return speed::mean_ratios({{"suite", "truth"}, {"models", models}});
  };
  const auto both = means({pair("cow", 0.02, 0.01, 50), pair("pig", 0.04, 0.32, 51)});
  REQUIRE(both.size() == 2);
  CHECK(both[0].error == "RMS");
  CHECK(both[0].share == "50 %");
  CHECK(both[0].geometric_mean == Approx(0.5));
  CHECK(both[0].worst == Approx(2));
  CHECK(both[0].worst_model == "cow");
  CHECK(both[0].models == 2);
  CHECK(both[1].error == "largest distance");
  CHECK(both[1].geometric_mean == Approx(0.5));

  CHECK(means({pair("cow", 0.02, 0.01, 50), pair("pig", 0.04, 0.32, 52)}).empty());  // one is left
  const auto exact = means({pair("cow", 1e-9, 1e-12, 50), pair("pig", 1e-3, 0, 50)});
  CHECK(exact[0].geometric_mean == Approx(std::sqrt(10.0)));
  CHECK(exact[0].worst == Approx(10));
}
