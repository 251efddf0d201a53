#include "chart/ScatterChart.hh"

#include "catch.hh"

using namespace whittle::chart;

TEST_CASE("points lie where the axes say and are joined in order") {
  ScatterChart chart;
  chart.width = 284;   // 70 to 270
  chart.height = 182;  // 32 or 40 to 132, below a legend of one row
  chart.series = {{"s", {{0, 0, "low"}, {10, 100, "high"}}, true}};
  const std::string svg = chart.svg();
  CHECK_THAT(svg, Catch::Contains("points=\"70,132 270,34\""));
  CHECK_THAT(svg, Catch::Contains("<title>low</title>") && Catch::Contains("<title>high</title>"));
  chart.series[0].joined = false;
  CHECK_THAT(chart.svg(), !Catch::Contains("<polyline"));
}

TEST_CASE("a logarithmic axis takes errors over many powers of ten") {
  ScatterChart chart;
  chart.y_scale = Scale::logarithmic;
  chart.series = {{"s", {{1, 0.001, ""}, {2, 0.1, ""}, {3, 10, ""}}, true}};
  const std::string svg = chart.svg();
  CHECK_THAT(svg,
             Catch::Contains(">0.001</text>") && Catch::Contains(">10</text>") && !Catch::Contains("nan"));
}

TEST_CASE("a scatter chart may have one point or none") {
  ScatterChart chart;
  CHECK_THAT(chart.svg(), Catch::EndsWith("</svg>\n") && !Catch::Contains("nan"));
  chart.series = {{"one", {{5, 5, "alone"}}, true}};
  CHECK_THAT(chart.svg(),
             Catch::Contains("alone") && !Catch::Contains("nan") && !Catch::Contains("<polyline"));
}
