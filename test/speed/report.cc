#include "speed/core.hh"
#include "speed/markdown.hh"

#include "catch.hh"
#include "meshes.hh"
#include "peers/precision.hh"

using namespace whittle;
using Catch::Matchers::Contains;

TEST_CASE("the page holds the machine, the goals and every contender") {
  const std::vector<speed::Subject> subjects(
      1, speed::make_subject("bunny", peers::in_float(meshes::torus(24, 16))));
  std::ostringstream quiet;
  terminal::Progress progress(quiet, terminal::ProgressStyle::silent);
  auto run = speed::run_json(2, "vt");
  const speed::Settings settings{speed::Suite::figures, 1, std::regex("vt|copy"), 500};
  run["suites"].push_back(speed::suite_json(settings, speed::run_rounds(settings, subjects, progress)));
  auto other = run;
  other["openmesh_core"]["label"] = "of another kind";
  const std::string page = speed::markdown({run, other});
  CHECK_THAT(page, Contains("| sweep | DecimaterT with the same module | bunny | "));
  CHECK_THAT(
      page,
      Contains(
          "| bulk | meshopt_simplifySloppy at the same face count | bunny | of another kind | ≤ 1× | vt "));
  CHECK_THAT(page, Contains("\n| DecimaterT vt | "));
  CHECK_THAT(page, Contains("| bulk vt | surface "));
  CHECK_THAT(page, Contains("2 threads") && Contains("meshoptimizer 0."));
  // Every row of a table has as many cells as its head.
  std::istringstream lines(page);
  std::ptrdiff_t cells = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto bars = std::count(line.begin(), line.end(), '|');
    if (bars == 0) cells = 0;
    if (bars > 0 && cells > 0) CHECK(bars == cells);
    if (bars > 0) cells = bars;
  }
}

TEST_CASE("the report names OpenMesh's core that runs") {
  const auto core = speed::openmesh_core();
  CHECK_THAT(core.file, Contains("libOpenMeshCore"));
  CHECK(core.label == (core.assertions ? "with assertions" : "without assertions"));
}
