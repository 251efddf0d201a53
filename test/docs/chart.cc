/// \file
/// The chart of docs/benchmark.md.
#include "chart/BarChart.hh"

#include <string>

#include "catch.hh"

TEST_CASE("page on the benchmark: the chart has its bar, with the value and the spread") {
#include "chart.inc"
  CHECK_THAT(svg, Catch::Contains("86 (43 to 114)") && Catch::Contains("improvement, %"));
}
