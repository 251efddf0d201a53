#include "report/Report.hh"

#include <algorithm>

#include "catch.hh"
#include "example.hh"
#include "report/base64.hh"
#include "report/sections.hh"
#include "results/text.hh"

using namespace whittle;

TEST_CASE("bytes become base64 with padding") {
  CHECK(bench::base64("").empty());
  CHECK(bench::base64("f") == "Zg==");
  CHECK(bench::base64("fo") == "Zm8=");
  CHECK(bench::base64("foo") == "Zm9v");
  CHECK(bench::base64("foobar") == "Zm9vYmFy");
  CHECK(bench::base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("a report rounds figures for readers") {
  CHECK(bench::fixed(-0.04, 1) == "0.0");
  CHECK(bench::fixed(-0.06, 1) == "-0.1");
  CHECK(bench::thousands(1234567) == "1,234,567");
  CHECK(bench::thousands(999) == "999");
  CHECK(bench::short_number(0.0000427) == "4.27e-05");
  CHECK(bench::spread_text({2, 1, 3}, 1) == "2.0 (1.0 to 3.0)");
  CHECK(bench::spread_text({2, 2, 2}, 0) == "2");
}

TEST_CASE("the page in Markdown has the tables with the papers' numbers beside ours") {
  const auto page = bench::markdown_text(bench::make_document(example::results()));
  CHECK_THAT(page, Catch::StartsWith("# Whittle render benchmark\n"));
  CHECK_THAT(page, Catch::Contains("> **Note:** Suzanne is not there."));
  CHECK_THAT(page, Catch::Contains("> **Note:** paper1: a note \\| with a bar."));
  CHECK_THAT(page, Catch::Contains("| Triangles | 65,630 | 1,000 | 0.015 |"));
  // 1,000 frames at a median of 1.5 ms.
  CHECK_THAT(page, Catch::Contains("| Paper, PC 1, NVIDIA GeForce GTX 1060 | 27.29 | 36,743 | 55 |"));
  CHECK_THAT(page, Catch::Contains("| VT | 200 | 400 | 60.0 | 0 | 0 | 0.0 |"));
  CHECK_THAT(page, Catch::Contains(
                       "| VT | 0.750 (0.500 to 1.000) | 0.675 | 1500.0 | 750.0 | 100.0 | 30.32 | 3.30 |"));
  CHECK_THAT(page, Catch::Contains("| FAD | 25.76 | 25.0 | 0.97 |"));
  CHECK_THAT(page, Catch::Contains("](charts/figure-11-12.svg)"));
  CHECK_THAT(page, Catch::Contains("![VT](pictures/detail.png)"));
}

TEST_CASE("fidelity is in parts of the mean edge") {
  const auto page = bench::markdown_text(bench::make_document(example::results()));
  CHECK_THAT(page, Catch::Contains("| VT | 400 | 10.00 | 5.00 | 100.00 | 12.5 | 90.0 | 0.750 | 0.250 | 30.5 "
                                   "(28.0) | 0.9500 (0.9000) | 0 |"));
  CHECK_THAT(page, Catch::Contains("| Whittle VT | 400 | 0.0 | 10.00 |"));
  CHECK_THAT(page, Catch::Contains("| … meshopt | 400 | 0.0 | 10.00 |"));
  CHECK_THAT(page,
             Catch::Contains(
                 "| VT | 0.000 | 0.000 | 0.750 (0.500 to 1.000) | 0.600 (0.400 to 0.800) | 100.0 | 150.0 |"));
}

TEST_CASE("a report names and marks a spread larger than the effect") {
  const auto page = bench::markdown_text(bench::make_document(example::results()));
  CHECK_THAT(page, Catch::Contains("cannot be told from this run: ivdd-0.0011."));
  CHECK_THAT(page, Catch::Contains("| -4.4 (-20.0 to 11.1) ≈ |"));
}

TEST_CASE("unfinished results make a report that says so") {
  auto results = example::results();
  results.complete = false;
  auto& sets = results.experiments[0].sets;
  sets[1].visits.pop_back();
  sets[2].visits.clear();
  sets[3] = {};
  sets[3].definition = {"fad-150", "FAD 150", "FAD", "150°", "fad:angle=150", "", bench::Role::paper};
  sets[4].note = "nothing is left to draw";
  const auto page = bench::markdown_text(bench::make_document(results));
  CHECK_THAT(page, Catch::Contains("This run is not finished"));
  CHECK_THAT(page, Catch::Contains("Fewer than 2 repetitions are there for: vt, fad-30."));
  CHECK_THAT(page, Catch::Contains("Timed once only, so nothing is known of the spread: vt."));
  CHECK_THAT(page, Catch::Contains("ivdd-0.0011: nothing is left to draw."));

  results.experiments.clear();
  CHECK_THAT(bench::markdown_text(bench::make_document(results)),
             Catch::Contains("Nothing has been timed yet."));
}

TEST_CASE("the HTML page escapes what it shows and needs no network") {
  const auto html = bench::html_text(bench::make_document(example::results()), "/nonexistent");
  CHECK_THAT(html, Catch::StartsWith("<!DOCTYPE html>") && Catch::EndsWith("</html>\n"));
  CHECK_THAT(html, Catch::Contains("a &lt;small&gt; bunny") && !Catch::Contains("<small>"));
  CHECK_THAT(html, Catch::Contains("prefers-color-scheme:dark") && Catch::Contains("@media print"));
  CHECK_THAT(html, Catch::Contains("<span class=\"badge odd\">more than claimed</span>"));
  CHECK_THAT(html, Catch::Contains("pictures/heat.png is not there"));
  for (const char* outside : {"src=\"http", "href=\"http", "<script", "url("})
    CHECK_THAT(html, !Catch::Contains(outside));
}

TEST_CASE("a scatter chart has one curve an algorithm, through its points in the order of their times") {
  const auto document = bench::make_document(example::results());
  std::string svg;
  for (const auto& section : document.sections)
    for (const auto& block : section.blocks)
      if (const auto* chart = std::get_if<bench::Chart>(&block); chart && chart->name == "error-frame-time")
        svg = chart->svg;
  CHECK_THAT(svg, Catch::Contains("<title>VT, passes 2: 0.375 ms, 20, 200 triangles</title>"));
  CHECK_THAT(svg, Catch::Contains(">VT</text>") && Catch::Contains(">meshopt</text>"));
}

TEST_CASE("the CSV has a line for each set and one for each time, all equally long") {
  const auto results = example::results();
  for (const auto& [csv, lines] :
       {std::pair(bench::csv_text(results), 12), std::pair(bench::times_csv_text(results), 23)}) {
    CHECK(std::count(csv.begin(), csv.end(), '\n') == lines);
    const auto commas = std::count(csv.begin(), csv.begin() + static_cast<long>(csv.find('\n')), ',');
    for (std::size_t begin = 0; begin < csv.size(); begin = csv.find('\n', begin) + 1) {
      const auto line = csv.substr(begin, csv.find('\n', begin) - begin);
      INFO(line);
      CHECK(std::count(line.begin(), line.end(), ',') == commas);
    }
  }
  CHECK_THAT(
      bench::csv_text(results),
      Catch::Contains(
          "\npaper1,vt,paper,VT,vt,,200,400,0,0,0,0,0.05,0.025,0.5,12.5,90,0.75,0.25,30.5,28,0.95,0.9,2,"
          "0.75,0.5,1,0.675,1500,100,100,100,clear\n"));
  CHECK_THAT(bench::times_csv_text(results), Catch::Contains("\npaper1,fad-30,2,1,1,100,160,\n"));
}
