/// \file
/// The benchmark as its users see it: options, files, exit codes.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.hh"
#include "experiment/GeneratedMesh.hh"
#include "files/MeshFile.hh"

using namespace whittle;
namespace fs = std::filesystem;

namespace {

std::string slurp(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A folder with a small ball in it, and the program run there by the shell.
class Bench {
 public:
  Bench() {
    std::string name = (fs::temp_directory_path() / "whittle-bench-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    folder_ = name;
    files::write_mesh(folder_ / "ball.obj", bench::generated_mesh(12));
  }
  ~Bench() { fs::remove_all(folder_); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  /// The exit code; what the program said is then in `out` and `err`.
  int run(const std::string& arguments, const std::string& before = "") {
    const std::string command = "cd '" + folder_.string() + "' && " + before +
                                " '" WHITTLE_BENCH_PROGRAM "' " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    out = slurp(folder_ / "out.txt");
    err = slurp(folder_ / "err.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::vector<std::string> files_in(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / name)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  const fs::path& folder() const { return folder_; }
  std::string out, err;

 private:
  fs::path folder_;
};

constexpr char kShort[] =
    "--model ball.obj --size 64x48 --frames-from 1 --frames-to 4 --repetitions 2 --out r ";

}  // namespace

TEST_CASE("a run leaves the results, the page and two pictures a set") {
  Bench bench;
  CHECK(bench.run(std::string(kShort) + "--sets ivdd-0.0013,fad-30 --label 'a ball'") == 0);
  CHECK(bench.files_in("r") ==
        std::vector<std::string>{"fad-30-ears.png", "fad-30.png", "ivdd-0.0013-ears.png", "ivdd-0.0013.png",
                                 "original-ears.png", "original.png", "results.json", "results.md"});
  const auto root = nlohmann::json::parse(slurp(bench.folder() / "r" / "results.json"));
  CHECK(root["model"]["label"] == "a ball");
  CHECK(root["model"]["file"] == "ball.obj");
  CHECK(root["settings"]["image_width_px"] == 64);
  CHECK(root["settings"]["image_height_px"] == 48);
  REQUIRE(root["sets"].size() == 3);
  for (const auto& set : root["sets"]) CHECK(set["repetitions"].size() == 2);
  CHECK_THAT(slurp(bench.folder() / "r" / "original.png"), Catch::Contains("Original, a ball"));
  // Not a terminal: plain lines, the last for the sixth of six visits.
  CHECK_THAT(bench.err, Catch::Contains("\n[6/6] repetition 2 of 2, ") && !Catch::Contains("\r"));
  CHECK_THAT(bench.out, Catch::Contains("results.md"));
}

TEST_CASE("an option given twice counts as given last, and sets may be given in several goes") {
  Bench bench;
  CHECK(bench.run(std::string(kShort) + "--out r2 --sets fad-30 --sets fad-150 --quiet") == 0);
  CHECK_FALSE(fs::exists(bench.folder() / "r"));
  CHECK(bench.files_in("r2").size() == 8);
}

TEST_CASE("pictures alone: no times, no results, and older results stay as they are") {
  Bench bench;
  fs::create_directories(bench.folder() / "r");
  std::ofstream(bench.folder() / "r" / "results.json") << "older";
  CHECK(bench.run("--model ball.obj --out r --pictures-only --sets vt") == 0);
  CHECK(bench.files_in("r") == std::vector<std::string>{"original-ears.png", "original.png", "results.json",
                                                        "vt-ears.png", "vt.png"});
  CHECK(slurp(bench.folder() / "r" / "results.json") == "older");
  CHECK(bench.out == "pictures are in r\n");
  CHECK_THAT(bench.err, !Catch::Contains("repetition"));
}

TEST_CASE("quiet is quiet") {
  Bench bench;
  CHECK(bench.run(std::string(kShort) + "--sets original --quiet") == 0);
  CHECK(bench.out.empty());
  CHECK(bench.err.empty());
}

TEST_CASE("bad usage and bad input end with 2 and one line") {
  Bench bench;
  std::ofstream(bench.folder() / "broken.obj") << "f 1 2 3\n";
  std::ofstream(bench.folder() / "points.obj") << "v 1 2 3\n";
  for (const char* arguments :
       {"--no-such-option", "--size 0", "--size 12x", "--size 99999", "--repetitions 0", "--repetitions many",
        "--frames-from 5 --frames-to 5", "--device x", "--device 99", "--sets fad-31",
        "--model missing.obj --out r", "--model broken.obj --out r", "--model points.obj --out r",
        "--model ball.obj --out err.txt/r"}) {
    INFO(arguments);
    CHECK(bench.run(arguments) == 2);
    INFO(bench.err);
    CHECK_THAT(bench.err, Catch::StartsWith("whittle-bench: "));
    CHECK(std::count(bench.err.begin(), bench.err.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(bench.folder() / "r"));
  }
}

TEST_CASE("without a usable EGL device it says what to install") {
  Bench bench;
  // An empty list of vendors leaves the EGL dispatch library without any driver.
  CHECK(bench.run(kShort, "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null") == 2);
  CHECK_THAT(bench.err, Catch::Contains("no EGL device") && Catch::Contains("install libegl1"));
  CHECK(std::count(bench.err.begin(), bench.err.end(), '\n') == 1);
}

TEST_CASE("an interrupt leaves no half file") {
  Bench bench;
  CHECK(bench.run("--model ball.obj --size 64 --frames-to 1000000 --out r --quiet",
                  "timeout -s INT --preserve-status 2") == 130);
  CHECK_THAT(bench.err, Catch::Contains("interrupted"));
  for (const auto& name : bench.files_in("r")) CHECK_THAT(name, Catch::EndsWith(".png"));
}

TEST_CASE("help, version and devices are answered") {
  Bench bench;
  CHECK(bench.run("--help") == 0);
  CHECK_THAT(bench.out, Catch::Contains("--frames-from"));
  CHECK(bench.run("--version") == 0);
  CHECK_THAT(bench.out, Catch::StartsWith("whittle-bench "));
  CHECK(bench.run("--list-devices") == 0);
  CHECK_FALSE(bench.out.empty());
}
