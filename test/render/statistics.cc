#include "experiment/Statistics.hh"

#include "catch.hh"
#include "experiment/Figures.hh"

using namespace whittle;

namespace {

bench::SetResult timed(std::size_t faces, const std::vector<double>& wall_ms) {
  bench::SetResult set;
  set.facts.faces = faces;
  for (const double ms : wall_ms) set.visits.push_back({1, {ms, ms / 2}});
  return set;
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

TEST_CASE("the fall in frame time is another figure") {
  CHECK(bench::frame_time_fall_percent(30, 20) == Approx(100.0 / 3));
  CHECK(bench::frame_time_fall_percent(10, 20) == Approx(-100));
}

TEST_CASE("a machine that slows down does not change the improvement") {
  const auto original = timed(1000, {100, 200, 400});
  const auto f = bench::figures(timed(600, {80, 160, 320}), original, {100, 1100});
  for (const double percent : f.improvement_percent) CHECK(percent == Approx(25));
  CHECK(f.improvement.median == Approx(25));
  CHECK(f.improvement.min == Approx(25));
  CHECK(f.improvement.max == Approx(25));
  CHECK(f.frame_time_fall.median == Approx(20));
  CHECK(f.triangles_removed_percent == Approx(40));
  CHECK(f.wall_total_ms.median == 160);
  CHECK(f.frame_mean_ms.median == Approx(0.16));
  CHECK(f.frames_per_second.median == Approx(6250));
  REQUIRE(f.gl_total_ms);
  CHECK(f.gl_total_ms->median == 80);
}

TEST_CASE("without OpenGL timers there is no figure of them") {
  auto set = timed(1, {1});
  set.visits[0].time.gl_ms.reset();
  CHECK_FALSE(bench::figures(set, set, {0, 1}).gl_total_ms);
}
