#include "chart/Axis.hh"

#include "catch.hh"

using namespace whittle::chart;

namespace {

void check(const std::vector<double>& ticks, const std::vector<double>& expected) {
  REQUIRE(ticks.size() == expected.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) CHECK(ticks[i] == Approx(expected[i]).margin(1e-12));
}

}  // namespace

TEST_CASE("linear ticks are round and cover the values") {
  check(linear_ticks(0, 97), {0, 20, 40, 60, 80, 100});
  check(linear_ticks(-3, 12), {-5, 0, 5, 10, 15});
  check(linear_ticks(0, 0.0013), {0, 0.0005, 0.001, 0.0015});
  check(linear_ticks(0, 100), {0, 20, 40, 60, 80, 100});
}

TEST_CASE("an axis over a single value has a length") {
  check(linear_ticks(0, 0), {0, 0.2, 0.4, 0.6, 0.8, 1});
  const auto around = linear_ticks(8, 8);
  CHECK(around.front() < 8);
  CHECK(around.back() > 8);
}

TEST_CASE("logarithmic ticks are 1, 2 and 5 times powers of ten") {
  check(log_ticks(0.3, 40), {0.2, 0.5, 1, 2, 5, 10, 20, 50});
  check(log_ticks(2, 5), {2, 5});
  check(log_ticks(1, 1), {1, 2});
}

TEST_CASE("logarithmic ticks over many decades are powers of ten") {
  check(log_ticks(0.002, 300), {0.001, 0.01, 0.1, 1, 10, 100, 1000});
}

TEST_CASE("an axis writes short numbers, with commas between thousands") {
  CHECK(number_text(0) == "0");
  CHECK(number_text(-0.0) == "0");
  CHECK(number_text(0.0013) == "0.0013");
  CHECK(number_text(12000) == "12,000");
  CHECK(number_text(-1234) == "-1,234");
  CHECK(number_text(-123) == "-123");
  CHECK(number_text(0.1 + 0.2) == "0.3");
}

TEST_CASE("an axis maps its first and last tick to its ends") {
  const Axis up(0, 97, 300, 100);
  CHECK(up.place(0) == Approx(300));
  CHECK(up.place(100) == Approx(100));
  CHECK(up.place(50) == Approx(200));
  const Axis logarithmic(1, 100, 0, 200, Scale::logarithmic);
  CHECK(logarithmic.place(10) == Approx(100));
}
