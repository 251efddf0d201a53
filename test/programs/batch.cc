#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::Folder;
using programs::whittle_program;
namespace fs = std::filesystem;

namespace {

/// Four good meshes, and one that is damaged.
struct Scans {
  Scans() {
    fs::create_directories(path() / "deep");
    const auto mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
    for (const char* name : {"a.ply", "b.obj", "deep/c.off", "d.stl"}) files::write_mesh(path() / name, mesh);
    std::ofstream(path() / "bad.obj") << "v 0 0 0\nf 1 2 3\n";
  }
  fs::path path() const { return folder.path() / "in"; }
  fs::path out() const { return folder.path() / "out"; }
  programs::Outcome run(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"batch", path().string(), "--out", out().string(), "--ratio", "0.25"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return whittle_program(arguments);
  }
  Folder folder;
};

std::vector<Json> log_lines(const fs::path& out) {
  std::vector<Json> lines;
  for (const auto& file : fs::directory_iterator(out / ".whittle/log")) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  }
  return lines;
}

}  // namespace

TEST_CASE("batch takes packed meshes, and tells as JSON what became of each") {
  const Scans scans;
  files::write_mesh(scans.path() / "e.ply.gz", meshes::torus(48, 28));
  const auto done = scans.run({"--json", "-"});
  CHECK(done.code == 1);
  const Json json = Json::parse(done.out);
  CHECK(json["statuses"] == Json{{"done", 5}, {"failed", 1}});
  REQUIRE(json["meshes"].size() == 6);
  for (const Json& mesh : json["meshes"]) {
    const bool bad = mesh["in"].get<std::string>().find("bad.obj") != std::string::npos;
    CHECK(mesh["status"] == (bad ? "failed" : "done"));
    CHECK(mesh["message"].is_null() == !bad);
    CHECK(mesh["faces_after"] == (bad ? 0 : 672));
  }
  CHECK(files::read_mesh(scans.out() / "e.ply.gz").report.format == "PLY, binary little endian, gzip");
  CHECK(scans.run({"--format", "off", "--json", scans.folder / "all.json"}).code == 1);
  CHECK(fs::exists(scans.out() / "e.off"));
  CHECK(Json::parse(programs::contents(scans.folder / "all.json"))["meshes"].size() == 6);
}

TEST_CASE("batch simplifies all meshes of a folder, and a bad one does not stop it") {
  const Scans scans;
  const auto done = scans.run({"--jobs", "2"});
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("5 meshes:") && Contains("4 done") && Contains("1 failed"));
  CHECK_THAT(done.err, Contains("bad.obj: failed"));
  for (const char* name : {"a.ply", "b.obj", "deep/c.off", "d.stl"})
    CHECK(files::read_mesh(scans.out() / name).mesh.triangles.size() == 672);
  CHECK_FALSE(fs::exists(scans.out() / "bad.obj"));
  const auto lines = log_lines(scans.out());
  REQUIRE(lines.size() == 5);
  for (const Json& line : lines) {
    const bool bad = line["file"].get<std::string>().find("bad.obj") != std::string::npos;
    CHECK(line["status"] == (bad ? "failed" : "done"));
    CHECK(line["faces_after"] == (bad ? 0 : 672));
  }
  CHECK(fs::is_empty(scans.out() / ".whittle/claims"));
  CHECK(fs::is_empty(scans.out() / ".whittle/work"));
}

TEST_CASE("batch resumes: what is done stays as it is, what has changed is done again") {
  const Scans scans;
  fs::remove(scans.path() / "bad.obj");
  REQUIRE(scans.run().code == 0);
  const auto before = fs::last_write_time(scans.out() / "a.ply");
  fs::remove(scans.out() / "b.obj");
  files::write_mesh(scans.path() / "d.stl", meshes::torus(20, 10));
  const auto again = scans.run({"--resume"});
  CHECK(again.code == 0);
  CHECK_THAT(again.out, Contains("2 done;") && Contains("2 done before;"));
  CHECK(fs::last_write_time(scans.out() / "a.ply") == before);
  CHECK(files::read_mesh(scans.out() / "b.obj").mesh.triangles.size() == 672);
  CHECK(files::read_mesh(scans.out() / "d.stl").mesh.triangles.size() == 100);
  CHECK_THAT(scans.run({"--resume", "--module", "ss"}).out, Contains("4 done;"));
}

TEST_CASE("batch resumes: a target that was missed before is missed still") {
  const Scans scans;
  fs::remove(scans.path() / "bad.obj");
  const std::vector<std::string> too_little{"--module", "ivdd:distance=0.000001"};
  const auto first = scans.run(too_little);
  CHECK(first.code == 1);
  CHECK_THAT(first.out, Contains(" target missed;"));
  const auto again = scans.run({"--resume", too_little[0], too_little[1]});
  CHECK(again.code == 1);
  CHECK_THAT(again.out, Contains(" target missed before;"));
  CHECK_THAT(again.err, Contains("a.ply: target missed before: "));
}

TEST_CASE("several batches on one folder share the work: each mesh is done once") {
  const Scans scans;
  fs::remove(scans.path() / "bad.obj");
  const auto mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  for (int i = 0; i < 20; ++i) files::write_mesh(scans.path() / ("more" + std::to_string(i) + ".ply"), mesh);
  std::vector<std::thread> threads;
  std::vector<int> codes(3, -1);
  for (int& code : codes)
    threads.emplace_back([&] {
      const std::string command = "'" WHITTLE_PROGRAM "' batch '" + scans.path().string() + "' --out '" +
                                  scans.out().string() + "' --ratio 0.25 --resume --jobs 1 --quiet";
      code = std::system(command.c_str());
    });
  for (auto& thread : threads) thread.join();
  for (const int code : codes) CHECK(code == 0);
  CHECK(log_lines(scans.out()).size() == 24);
}

TEST_CASE("batch takes a manifest, another format, and limits") {
  const Scans scans;
  std::ofstream(scans.folder.path() / "list.txt") << "# two\nin/a.ply\nin/deep/c.off\n";
  const auto done = whittle_program({"batch", scans.folder / "list.txt", "--out", scans.out().string(),
                                     "--format", "glb", "--faces", "500", "--time-limit", "300"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK(files::read_mesh(scans.out() / "a.glb").mesh.triangles.size() == 500);
  CHECK(files::read_mesh(scans.out() / "c.glb").mesh.triangles.size() == 500);
  const auto late = scans.run({"--time-limit", "0.001", "--module", "quadric", "--driver", "decimater"});
  CHECK(late.code == 1);
  CHECK_THAT(late.err, Contains("out of time"));
}

TEST_CASE("an impossible batch is refused before anything is started") {
  const Scans scans;
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--module", "nothing"},
                                               {"--jobs", "0"},
                                               {"--format", "doc"},
                                               {"--ratio", "2"}}) {
    const auto bad = scans.run(more);
    INFO(more[0]);
    CHECK(bad.code == 2);
    CHECK(bad.error_lines() == 1);
    CHECK_FALSE(fs::exists(scans.out()));
  }
  CHECK(whittle_program({"batch", scans.folder / "nothing", "--out", scans.out().string(), "--ratio", "0.5"})
            .code == 2);
}
