#include "chart/BarChart.hh"

#include "catch.hh"

using namespace whittle::chart;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

BarChart example() {
  BarChart chart;
  chart.title = "two groups";
  chart.value_axis = "percent";
  chart.claim_name = "claimed";
  chart.legend = {"first", "second"};
  chart.groups = {{"A", {{"a1", 50, Spread{40, 60}, 0}, {"a2", 100, std::nullopt, 1}}, 30.0},
                  {"B", {{"b1", -20, std::nullopt, 0}}, std::nullopt}};
  return chart;
}

}  // namespace

TEST_CASE("every bar is there, with its value as a label and a tip") {
  const std::string svg = example().svg();
  CHECK(count(svg, "<title>") == 3);
  CHECK_THAT(svg, Catch::Contains("<title>A a1: 50 (40 to 60)</title>"));
  CHECK_THAT(svg, Catch::Contains("<title>B b1: -20</title>"));
  CHECK_THAT(svg, Catch::Contains(">first</text>") && Catch::Contains(">percent</text>"));
}

TEST_CASE("an error bar is a line with two ends, a claim one across its group") {
  const std::string svg = example().svg();
  CHECK(count(svg, "class=\"whisker\"") == 3);
  CHECK(count(svg, "class=\"claim\"") == 2);  // the group's, and the one in the legend
  BarChart plain = example();
  plain.groups[0].claim.reset();
  CHECK(count(plain.svg(), "class=\"claim\"") == 0);
  CHECK(count(plain.svg(), "claimed") == 0);
}

TEST_CASE("bars stand on zero, whichever way they go") {
  BarChart chart;
  chart.width = 276;  // 206 pixels for the bars: a group of two and one of one need five units
  chart.groups = {{"A", {{"", 10, std::nullopt, 0}, {"", 20, std::nullopt, 0}}, std::nullopt},
                  {"B", {{"", -20, std::nullopt, 0}}, std::nullopt}};
  // The axis runs from -20 to 20 over 298 pixels, from 16 to 314; zero lies at 165.
  const std::string svg = chart.svg();
  CHECK_THAT(svg, Catch::Contains("y=\"90.5\" width=\"32.96\" height=\"74.5\""));
  CHECK_THAT(svg, Catch::Contains("y=\"16\" width=\"32.96\" height=\"149\""));
  CHECK_THAT(svg, Catch::Contains("y=\"165\" width=\"32.96\" height=\"149\""));
}

TEST_CASE("a chart without bars is empty axes") {
  const std::string svg = BarChart().svg();
  CHECK_THAT(svg, Catch::EndsWith("</svg>\n") && !Catch::Contains("nan") && !Catch::Contains("inf"));
}
