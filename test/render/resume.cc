/// \file
/// Runs that do not come to their end: signals, full disks, and going on afterwards.
#include <nlohmann/json.hpp>

#include "Bench.hh"

using namespace bench_program;
using nlohmann::json;

namespace {

json results(const Bench& bench) {
  return json::parse(scratch::contents(bench.folder() / "r" / "results.json"));
}

std::size_t visits(const json& root) {
  std::size_t count = 0;
  for (const auto& set : root["experiments"][0]["sets"]) count += set["times"].size();
  return count;
}

/// Far more repetitions than there is time for, for a ball.
constexpr char kLong[] =
    "--model ball.obj --experiments paper1 --sets vt --size 64 --frames-from 0 --frames-to 20 --repetitions "
    "1000 "
    "--views 1 --samples 100 --out r --quiet ";

}  // namespace

TEST_CASE("a killed run keeps its results whole, a report can be made, and --resume goes on") {
  Bench bench;
  CHECK(bench.run_and_signal(kLong, "KILL", 5) == 128 + 9);
  const auto before = results(bench);
  CHECK(before["complete"] == false);
  CHECK(before["starts"] == 1);
  const std::size_t kept = visits(before);
  CHECK(kept >= 5);
  CHECK(bench.run("report r/results.json") == 0);
  CHECK_THAT(scratch::contents(bench.folder() / "r/report.md"), Catch::Contains("This run is not finished"));

  CHECK(bench.run_and_signal(std::string(kLong) + "--resume", "TERM", kept + 3) == 128 + 15);
  CHECK_THAT(bench.err, Catch::Contains("interrupted; what was timed so far is kept"));
  const auto after = results(bench);
  CHECK(after["starts"] == 2);
  CHECK(visits(after) >= kept + 3);
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t i = 0; i < before["experiments"][0]["sets"][s]["times"].size(); ++i)
      CHECK(after["experiments"][0]["sets"][s]["times"][i] ==
            before["experiments"][0]["sets"][s]["times"][i]);
}

TEST_CASE("a resumed run that is whole already only makes its report again") {
  Bench bench;
  REQUIRE(bench.run(std::string(kShort) + "--sets vt --quiet") == 0);
  const auto before = results(bench);
  CHECK(bench.run(std::string(kShort) + "--sets vt --quiet --resume") == 0);
  const auto after = results(bench);
  CHECK(after["experiments"] == before["experiments"]);
  CHECK(after["starts"] == 2);
}

TEST_CASE("other options than before do not go on with the results, and leave them alone") {
  Bench bench;
  REQUIRE(bench.run(std::string(kShort) + "--sets vt --quiet") == 0);
  const auto before = scratch::contents(bench.folder() / "r/results.json");
  CHECK(bench.run(std::string(kShort) + "--sets vt --quiet --resume --size 32") == 2);
  CHECK(bench.err ==
        "whittle-bench: --resume: cannot go on with these results: the image size was 64x48 and is now "
        "32x32\n");
  CHECK(scratch::contents(bench.folder() / "r/results.json") == before);
}

TEST_CASE("without --resume older results are set aside, not written over") {
  Bench bench;
  REQUIRE(bench.run(std::string(kShort) + "--sets vt --quiet") == 0);
  const auto before = scratch::contents(bench.folder() / "r/results.json");
  CHECK(bench.run(std::string(kShort) + "--sets original --quiet") == 0);
  CHECK_THAT(bench.err, Catch::Contains("results.1.json"));
  CHECK(scratch::contents(bench.folder() / "r/results.1.json") == before);
}

TEST_CASE("a full disk ends whittle-bench with 1 and one line, and what was saved stays") {
  Bench bench;
  REQUIRE(bench.run(std::string(kShort) + "--sets vt --quiet") == 0);
  const auto before = scratch::contents(bench.folder() / "r/results.json");
  // A limit on the size of files stands in for a disk that is full: the program gets an error when it writes.
  const std::string full = "ulimit -f 1; trap '' XFSZ;";
  CHECK(bench.run(std::string(kShort) + "--sets vt --quiet --resume", full) == 1);
  INFO(bench.err);
  CHECK_THAT(bench.err,
             Catch::StartsWith("whittle-bench: r/results.json: ") && Catch::Contains("--resume goes on"));
  CHECK(std::count(bench.err.begin(), bench.err.end(), '\n') == 1);
  CHECK(scratch::contents(bench.folder() / "r/results.json") == before);
  // With room again it goes on.
  CHECK(bench.run(std::string(kShort) + "--sets vt --quiet --resume") == 0);
  CHECK(results(bench)["complete"] == true);
  CHECK(bench.run("report r/results.json --out new", full) == 1);
  CHECK(std::count(bench.err.begin(), bench.err.end(), '\n') == 1);
}
