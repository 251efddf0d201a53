/// \file
/// The benchmark as its users see it: options, files, exit codes.
#include <nlohmann/json.hpp>
#include <set>

#include "../programs/Process.hh"
#include "files/MeshFile.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using AnyJson = nlohmann::json;

namespace {

std::string torus_in(const programs::Folder& folder) {
  const std::string path = folder / "torus.ply";
  files::write_mesh(path, meshes::torus(24, 16));
  return path;
}

}  // namespace

TEST_CASE("one round of whittle-speed on a small mesh writes a record of all contenders, and a page") {
  const programs::Folder folder;
  const std::string out = folder / "r";
  const auto done = programs::run(WHITTLE_SPEED_PROGRAM, {torus_in(folder), "--rounds", "1", "--samples",
                                                          "500", "--out", out, "--quiet"});
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK(done.out.empty());
  const AnyJson run = AnyJson::parse(programs::contents(out + "/speed.json"));
  CHECK(run["schema"] == "whittle-speed");
  CHECK(run["machine"]["memory_bytes"] > 0);
  CHECK(run["settings"]["threads"] >= 1);
  REQUIRE(run["suites"].size() == 1);
  const AnyJson& model = run["suites"][0]["models"][0];
  CHECK(model["name"] == "torus");
  CHECK(model["faces"] == 768);
  CHECK(run["suites"][0]["samples"] == 500);
  std::set<std::string> names;
  for (const AnyJson& result : model["results"]) {
    names.insert(result["name"]);
    CHECK(result["seconds"]["rounds"].size() == 1);
  }
  for (const std::string module : {"vt", "fad", "ivdd", "ss", "vtd", "fass"})
    for (const std::string method :
         {"bulk ", "sweep ", "lazy ", "DecimaterT ", "meshopt_simplify as ", "meshopt_simplifySloppy as "})
      CHECK(names.count(method + module) == 1);
  for (const std::string share : {"50 %", "10 %"})
    for (const std::string method : {"lazy quadric ", "lazy quadric + normal-flipping ",
                                     "DecimaterT quadric ", "DecimaterT quadric + normal-flipping ",
                                     "McDecimaterT quadric ", "meshopt_simplify ", "meshopt_simplifySloppy "})
      CHECK(names.count(method + share) == 1);
  for (const char* name : {"copy of the arrays", "arrays to OpenMesh", "OpenMesh to arrays",
                           "compact after ivdd", "garbage_collection after ivdd"})
    CHECK(names.count(name) == 1);
  CHECK_THAT(programs::contents(out + "/speed.md"), Contains("## Goals"));
}

TEST_CASE("the growth suite subdivides the last model") {
  const programs::Folder folder;
  const auto done = programs::run(WHITTLE_SPEED_PROGRAM, {torus_in(folder), "--suite", "growth", "--rounds",
                                                          "1", "--subdivisions", "1", "--out", folder / "r"});
  CHECK(done.code == 0);
  const AnyJson models = AnyJson::parse(programs::contents(folder / "r/speed.json"))["suites"][0]["models"];
  REQUIRE(models.size() == 2);
  CHECK(models[1]["name"] == "torus x4");
  CHECK(models[1]["faces"] == 4 * 768);
  CHECK_THAT(programs::contents(folder / "r/speed.md"), Contains("time per triangle on torus"));
}

TEST_CASE("results of several runs become one page") {
  const programs::Folder folder;
  const std::string out = folder / "r";
  for (const char* name : {"a", "b"})
    REQUIRE(
        programs::run(WHITTLE_SPEED_PROGRAM, {torus_in(folder), "--rounds", "1", "--only", "compact|garbage",
                                              "--out", out, "--name", name, "--threads", "1"})
            .code == 0);
  CHECK(AnyJson::parse(programs::contents(out + "/a.json"))["settings"]["threads"] == 1);
  const auto done = programs::run(
      WHITTLE_SPEED_PROGRAM, {"--report", out + "/a.json", out + "/b.json", "--out", out, "--name", "both"});
  CHECK(done.code == 0);
  const std::string page = programs::contents(out + "/both.md");
  const auto first = page.find("| compact() |");
  REQUIRE(first != std::string::npos);
  CHECK(page.find("| compact() |", first + 1) != std::string::npos);
}

TEST_CASE("bad usage and bad input end whittle-speed with 2 and one line, and nothing is written") {
  const programs::Folder folder;
  const std::string torus = torus_in(folder), points = folder / "points.obj", poem = folder / "poem.json",
                    half = folder / "half.json", huge = folder / "huge.obj";
  std::ofstream(points) << "v 1 2 3\n";
  std::ofstream(poem) << "the fog comes\n";
  std::ofstream(half) << R"({"schema": "whittle-speed", "schema_version": 1, "suites": []})";
  std::ofstream(huge) << "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::vector<std::vector<std::string>> bad = {{folder / "none.ply"},
                                                     {points},
                                                     {huge},
                                                     {torus, "--no-such-option"},
                                                     {torus, "--rounds", "0"},
                                                     {torus, "--rounds", "many"},
                                                     {torus, "--only", "("},
                                                     {torus, "--suite", "some"},
                                                     {torus, "--name", "a/b"},
                                                     {torus, "--threads", "4096"},
                                                     {torus, "--suite", "textured"},
                                                     {torus, "--export", folder / "r"},
                                                     {"--suite", "textured", "--compare", folder / "none"},
                                                     {"--report", poem},
                                                     {"--report", half},
                                                     {"--report", folder / "none.json"}};
  for (auto arguments : bad) {
    arguments.insert(arguments.end(), {"--out", folder / "r"});
    INFO(arguments[0] << " " << arguments[1]);
    const auto done = programs::run(WHITTLE_SPEED_PROGRAM, arguments);
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK_THAT(done.err, Contains("whittle-speed: "));
    CHECK_FALSE(std::filesystem::exists(folder / "r"));
  }
}

TEST_CASE("the suite of textured models writes them for other programs, and measures a file") {
  const programs::Folder folder;
  const std::string models = folder / "models", out = folder / "r";
  const auto exported = programs::run(
      WHITTLE_SPEED_PROGRAM,
      {"--suite", "textured", "--only", "^soft-hills-mirrored$", "--export", models, "--quiet"});
  CHECK(exported.code == 0);
  const std::string model = models + "/soft-hills-mirrored.glb";
  REQUIRE(files::read_mesh(model).attributes.size() == 1);
  std::filesystem::rename(model, models + "/mine.glb");
  const auto done =
      programs::run(WHITTLE_SPEED_PROGRAM, {models + "/mine.glb", "--suite", "textured", "--only", "^mine$",
                                            "--rounds", "1", "--samples", "500", "--out", out, "--quiet"});
  INFO(done.err);
  CHECK(done.code == 0);
  const AnyJson run = AnyJson::parse(programs::contents(out + "/speed.json"));
  CHECK(run["suites"][0]["models"][0]["half"] == "given");
  CHECK(run["suites"][0]["models"][0]["results"].size() == 5);
  CHECK_THAT(programs::contents(out + "/speed.md"), Contains("| mine | 10 | mq | "));
  const auto again = programs::run(
      WHITTLE_SPEED_PROGRAM, {"--report", out + "/speed.json", "--out", out, "--name", "again", "--quiet"});
  CHECK(again.code == 0);
  CHECK(programs::contents(out + "/again.md") == programs::contents(out + "/speed.md"));
}

TEST_CASE("whittle-speed answers --help and --version") {
  CHECK_THAT(programs::run(WHITTLE_SPEED_PROGRAM, {"--help"}).out, Contains("--rounds"));
  CHECK_THAT(programs::run(WHITTLE_SPEED_PROGRAM, {"--version"}).out, Contains("whittle-speed "));
}
