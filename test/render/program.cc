/// \file
/// The benchmark as its users see it: options, files, exit codes.
#include <nlohmann/json.hpp>

#include "Bench.hh"

using namespace bench_program;

TEST_CASE("a run leaves the results, the report and the pictures") {
  Bench bench;
  CHECK(bench.run(std::string(kShort) + "--sets ivdd-0.0013,fad-30 --label 'a ball'") == 0);
  CHECK(bench.files_in("r") == std::vector<std::string>{"charts", "pictures", "report.csv", "report.html",
                                                        "report.md", "results.json", "times.csv"});
  CHECK(bench.files_in("r/pictures").size() == 8);
  CHECK(bench.files_in("r/charts") == std::vector<std::string>{"figure-11-12.svg", "figure-9-10.svg"});
  const auto root = nlohmann::json::parse(scratch::contents(bench.folder() / "r" / "results.json"));
  CHECK(root["complete"] == true);
  CHECK(root["protocol"] == "quick, changed by options");
  CHECK(root["settings"]["image_width_px"] == 64);
  CHECK(root["settings"]["image_height_px"] == 48);
  const auto& experiment = root["experiments"][0];
  CHECK(experiment["model"]["label"] == "a ball");
  CHECK(experiment["model"]["file"] == "ball.obj");
  REQUIRE(experiment["sets"].size() == 3);
  for (const auto& set : experiment["sets"]) CHECK(set["times"].size() == 2);
  CHECK_FALSE(experiment["sets"][1]["fidelity"].is_null());
  CHECK_THAT(scratch::contents(bench.folder() / "r/pictures/paper1-original-whole.png"),
             Catch::Contains("Original, a ball"));
  // Not a terminal: plain lines, the last for the sixth of six visits.
  CHECK_THAT(bench.err, Catch::Contains("\n[6/6] paper1, repetition 2 of 2, ") && !Catch::Contains("\r"));
  CHECK_THAT(bench.out, Catch::Contains("report.html"));
}

TEST_CASE("all three experiments run on small models") {
  Bench bench;
  CHECK(
      bench.run("--model ball.obj --monkey ball.obj --size 32 --frames-from 0 --frames-to 1 --repetitions 1 "
                "--views 1 --samples 100 --out r --quiet --sets vt") == 0);
  const auto root = nlohmann::json::parse(scratch::contents(bench.folder() / "r" / "results.json"));
  REQUIRE(root["experiments"].size() == 3);
  for (const auto& experiment : root["experiments"])
    for (const auto& set : experiment["sets"]) {
      INFO(experiment["name"] << " " << set["name"]);
      CHECK(set["triangles"] > 0);
      CHECK(set["times"].size() == 1);
      CHECK(set["fidelity"].is_null() == (set["name"] == "original" || set["role"] == "cache"));
    }
  const auto page = scratch::contents(bench.folder() / "r" / "report.html");
  CHECK_THAT(page, Catch::Contains("id=\"peers\"") && Catch::Contains("id=\"error-frame-time\"") &&
                       Catch::Contains("nothing is known of the spread") && !Catch::Contains("is not there"));
}

TEST_CASE("the report can be made again from the results alone, there or elsewhere") {
  Bench bench;
  REQUIRE(bench.run(std::string(kShort) + "--sets vt --quiet") == 0);
  const auto html = scratch::contents(bench.folder() / "r/report.html");
  fs::remove(bench.folder() / "r/report.html");
  // Without a driver nothing could be drawn.
  CHECK(bench.run("report r/results.json", "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null") == 0);
  CHECK(scratch::contents(bench.folder() / "r/report.html") == html);
  CHECK(bench.run("report r/results.json --out elsewhere") == 0);
  CHECK(scratch::contents(bench.folder() / "elsewhere/report.html") == html);
}

TEST_CASE("whittle-bench takes the last of a repeated option, and sets from several") {
  Bench bench;
  CHECK(bench.run(std::string(kShort) + "--out r2 --sets fad-30 --sets fad-150 --quiet") == 0);
  CHECK_FALSE(fs::exists(bench.folder() / "r"));
  CHECK(bench.files_in("r2/pictures").size() == 8);
}

TEST_CASE("whittle-bench with pictures alone writes no times and no results, and older results stay") {
  Bench bench;
  fs::create_directories(bench.folder() / "r");
  std::ofstream(bench.folder() / "r" / "results.json") << "older";
  CHECK(bench.run("--model ball.obj --experiments paper1 --out r --pictures-only --sets vt") == 0);
  CHECK(bench.files_in("r") == std::vector<std::string>{"pictures", "results.json"});
  CHECK(bench.files_in("r/pictures") ==
        std::vector<std::string>{"paper1-original-detail.png", "paper1-original-whole.png",
                                 "paper1-vt-detail.png", "paper1-vt-heat.png", "paper1-vt-whole.png"});
  CHECK(scratch::contents(bench.folder() / "r" / "results.json") == "older");
  CHECK(bench.out == "pictures are in r/pictures\n");
  CHECK_THAT(bench.err, !Catch::Contains("repetition"));
}

TEST_CASE("whittle-bench --quiet writes nothing") {
  Bench bench;
  CHECK(bench.run(std::string(kShort) + "--sets original --quiet") == 0);
  CHECK(bench.out.empty());
  CHECK(bench.err.empty());
}

TEST_CASE("bad usage and bad input end whittle-bench with 2 and one line") {
  Bench bench;
  std::ofstream(bench.folder() / "broken.obj") << "f 1 2 3\n";
  std::ofstream(bench.folder() / "points.obj") << "v 1 2 3\n";
  std::ofstream(bench.folder() / "line.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
  std::ofstream(bench.folder() / "cut.json") << "{\"schema\":";
  for (const char* arguments : {"--no-such-option",
                                "--size 0",
                                "--size 12x",
                                "--size 99999",
                                "--repetitions 0",
                                "--repetitions many",
                                "--frames-from 5 --frames-to 5",
                                "--frames-from 1000000",
                                "--device x",
                                "--device 99",
                                "--sets fad-31",
                                "--experiments paper3",
                                "--views 15",
                                "--quick --paper",
                                "--model missing.obj --out r",
                                "--model broken.obj --out r",
                                "--model points.obj --out r",
                                "--model line.obj --out r",
                                "--monkey points.obj --model ball.obj --out r",
                                "--model ball.obj --out err.txt/r",
                                "--model ball.obj --out /dev/full",
                                "report",
                                "report missing.json",
                                "report cut.json",
                                "report ball.obj",
                                "report /"}) {
    INFO(arguments);
    CHECK(bench.run(arguments) == 2);
    INFO(bench.err);
    CHECK_THAT(bench.err, Catch::StartsWith("whittle-bench: "));
    CHECK(std::count(bench.err.begin(), bench.err.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(bench.folder() / "r"));
  }
}

TEST_CASE("whittle-bench without a usable EGL device names what to install") {
  Bench bench;
  // An empty list of vendors leaves the EGL dispatch library without any driver.
  CHECK(bench.run(kShort, "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null") == 2);
  CHECK_THAT(bench.err, Catch::Contains("no EGL device") && Catch::Contains("install libegl1"));
  CHECK(std::count(bench.err.begin(), bench.err.end(), '\n') == 1);
}

TEST_CASE("whittle-bench answers --help, --version and --devices") {
  Bench bench;
  CHECK(bench.run("--help") == 0);
  CHECK_THAT(bench.out, Catch::Contains("--frames-from") && Catch::Contains("report"));
  CHECK(bench.run("--version") == 0);
  CHECK_THAT(bench.out,
             Catch::StartsWith("whittle-bench ") && Catch::Contains("commit") && Catch::Contains("OpenMesh"));
  CHECK(bench.run("--list-devices") == 0);
  CHECK_FALSE(bench.out.empty());
}
