#include "results/Statistics.hh"

#include "catch.hh"
#include "results/Figures.hh"

using namespace whittle;

namespace {

/// An experiment of frames 100 to 1,100: the original with 1,000 triangles, and one set.
bench::ExperimentResult timed(const std::vector<double>& original_ms, std::size_t triangles,
                              const std::vector<double>& wall_ms) {
  bench::ExperimentResult e;
  e.sets.resize(2);
  e.sets[0].triangles = 1000;
  e.sets[1].triangles = triangles;
  for (std::size_t i = 0; i < original_ms.size(); ++i)
    e.sets[0].visits.push_back({i + 1, 1, 1, original_ms[i], original_ms[i] / 2});
  for (std::size_t i = 0; i < wall_ms.size(); ++i)
    e.sets[1].visits.push_back({i + 1, 1, 1, wall_ms[i], wall_ms[i] / 2});
  return e;
}

}  // namespace

TEST_CASE("the median of an odd number of values is the one in the middle") {
  const auto summary = bench::summarise({9, 1, 4});
  CHECK(summary.median == 4);
  CHECK(summary.min == 1);
  CHECK(summary.max == 9);
}

TEST_CASE("the median of an even number of values lies halfway") {
  CHECK(bench::summarise({8, 1, 4, 2}).median == 3);
  CHECK(bench::summarise({5}).median == 5);
}

TEST_CASE("improvement is the rise in frames per second") {
  CHECK(bench::improvement_percent(30, 20) == Approx(50));
  CHECK(bench::improvement_percent(10, 20) == Approx(-50));
  CHECK(bench::improvement_percent(7, 7) == 0);
}

TEST_CASE("the fall in frame time is not the improvement") {
  CHECK(bench::frame_time_fall_percent(30, 20) == Approx(100.0 / 3));
  CHECK(bench::frame_time_fall_percent(10, 20) == Approx(-100));
}

TEST_CASE("a machine that slows down does not change the improvement") {
  const auto e = timed({100, 200, 400}, 600, {80, 160, 320});
  const auto f = bench::figures(e.sets[1], e);
  REQUIRE(f);
  for (const double percent : f->improvement_percent) CHECK(percent == Approx(25));
  CHECK(f->improvement.median == Approx(25));
  CHECK(f->improvement.min == Approx(25));
  CHECK(f->improvement.max == Approx(25));
  CHECK(f->frame_time_fall.median == Approx(20));
  CHECK(f->triangles_removed_percent == Approx(40));
  CHECK(f->wall_total_ms.median == 160);
  CHECK(f->frame_mean_ms.median == Approx(0.16));
  CHECK(f->frames_per_second.median == Approx(6250));
  CHECK(f->frames_per_second_gained.median == Approx(1250));
  REQUIRE(f->gl_total_ms);
  CHECK(f->gl_total_ms->median == 80);
  CHECK(f->certainty == bench::Certainty::clear);
}

TEST_CASE("a set's figures have no OpenGL time without OpenGL timers") {
  auto e = timed({1}, 1, {1});
  e.sets[1].visits[0].gl_ms.reset();
  CHECK_FALSE(bench::figures(e.sets[1], e)->gl_total_ms);
}

TEST_CASE("times of different starts are not compared with one another") {
  auto e = timed({100, 200}, 600, {50, 100});
  e.sets[1].visits[1].start = 2;  // the original's second time is from the first start
  auto f = bench::figures(e.sets[1], e);
  REQUIRE(f);
  CHECK(f->improvement_percent.size() == 1);
  e.sets[0].visits.push_back({2, 2, 1, 400, {}});
  f = bench::figures(e.sets[1], e);
  REQUIRE(f->improvement_percent.size() == 2);
  CHECK(f->improvement_percent[1] == Approx(300));
}

TEST_CASE("without a time of its own, or of the original, a set has no figures") {
  auto e = timed({}, 600, {50});
  CHECK_FALSE(bench::figures(e.sets[1], e));
  e = timed({100}, 600, {});
  CHECK_FALSE(bench::figures(e.sets[1], e));
}

TEST_CASE("a spread larger than the effect is told from a clear one") {
  CHECK(bench::certainty({2, 1, 4}, 3) == bench::Certainty::spread_exceeds_effect);
  CHECK(bench::certainty({-2, -3, -1.5}, 3) == bench::Certainty::clear);
  CHECK(bench::certainty({2, 1, 3}, 3) == bench::Certainty::clear);
  CHECK(bench::certainty({2, 2, 2}, 1) == bench::Certainty::one_repetition);
}
