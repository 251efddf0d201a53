#include "chart/Svg.hh"

#include "catch.hh"

using namespace whittle::chart;

TEST_CASE("SVG text is escaped for XML") {
  CHECK(escape("a < b & \"c\" > 'd'") == "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
}

TEST_CASE("SVG coordinates have two decimals at most") {
  CHECK(coordinate(1.23456) == "1.23");
  CHECK(coordinate(2) == "2");
  CHECK(coordinate(100) == "100");
  CHECK(coordinate(-0.001) == "0");
}

TEST_CASE("a picture has a size, a label and its shapes") {
  Svg svg(30, 20, "a <label>");
  svg.line(0, 1, 2, 3.5, "grid");
  svg.rectangle(1, 2, 3, 4, "f0", "a tip");
  svg.text(5, 6, "A & B", Anchor::end);
  const std::string text = svg.finish();
  CHECK_THAT(text,
             Catch::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\"") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(text,
             Catch::Contains("viewBox=\"0 0 30 20\"") && Catch::Contains("aria-label=\"a &lt;label&gt;\""));
  CHECK_THAT(text, Catch::Contains("<line class=\"grid\" x1=\"0\" y1=\"1\" x2=\"2\" y2=\"3.5\"/>"));
  CHECK_THAT(text, Catch::Contains("height=\"4\"><title>a tip</title></rect>"));
  CHECK_THAT(text, Catch::Contains("text-anchor=\"end\">A &amp; B</text>"));
}

TEST_CASE("four series in a row have markers of four shapes") {
  Svg svg(10, 10, "");
  for (int series = 0; series < 4; ++series) svg.marker(5, 5, series);
  const std::string text = svg.finish();
  CHECK_THAT(text, Catch::Contains("<circle class=\"f0\"") && Catch::Contains("<rect class=\"f1\"") &&
                       Catch::Contains("<polygon class=\"f2\"") && Catch::Contains("<polygon class=\"f3\""));
}
