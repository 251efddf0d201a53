/// \file
/// What a run writes: all of it or nothing, and never over what it reads.
#include <sys/stat.h>

#include <map>
#include <nlohmann/json.hpp>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::Folder;
using programs::whittle_program;
namespace fs = std::filesystem;

namespace {

/// Three small meshes and a selection.
struct Given {
  Given() {
    files::write_mesh(folder / "s.ply", meshes::torus(8, 5));
    files::write_mesh(folder / "o.ply", meshes::torus(7, 4));
    files::write_mesh(folder / "z-lod2.ply", meshes::torus(8, 5));
    fs::create_symlink("s.ply", folder / "link.ply");
    std::ofstream(folder / "keep.txt") << "0 1\n";
  }
  std::map<std::string, std::string> all_files() const {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      out[entry.path().filename()] = programs::contents(entry.path());
    return out;
  }
  /// Words that begin with @ are files of the folder.
  programs::Outcome run(std::vector<std::string> words) const {
    for (std::string& word : words)
      if (const std::size_t at = word.find('@'); at != std::string::npos)
        word = word.substr(0, at) + folder / word.substr(at + 1);
    return whittle_program(words);
  }
  Folder folder;
};

}  // namespace

TEST_CASE(
    "a run whose outputs would meet each other or an input is refused with both named, and changes nothing") {
  const Given given;
  const auto before = given.all_files();
  const std::vector<std::string> simplify{"simplify", "@s.ply", "@o.ply", "--ratio", "0.5"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), simplify.begin(), simplify.end());
    return more;
  };
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> cases{
      {with({"--map", "@o.ply"}), {"OUT", "--map", "o.ply"}},
      {with({"--json", "@o.ply"}), {"OUT", "--json", "o.ply"}},
      {with({"--map", "@s.ply"}), {"--map", "IN", "s.ply"}},
      {with({"--json", "@link.ply"}), {"--json", "IN", "s.ply"}},
      {with({"--map", "@X", "--json", "@X"}), {"--map", "--json", "X"}},
      {with({"--map", "@X", "--json", "@x"}), {"--map", "--json", "X"}},
      {with({"--map", "-", "--json", "-"}), {"--map", "--json", "standard output"}},
      {with({"--lock", "selection:@keep.txt", "--json", "@keep.txt"}), {"--json", "--lock", "keep.txt"}},
      {{"simplify", "@s.ply", "-", "--format", "ply", "--ratio", "0.5", "--json", "-"}, {"OUT", "--json"}},
      {{"lods", "@s.ply", "--out", "@y.glb", "--json", "@y.glb"}, {"--out", "--json", "y.glb"}},
      {{"lods", "@z-lod2.ply", "--out", "@z.ply"}, {"level 2", "MODEL", "z-lod2.ply"}},
      {{"lods", "@s.ply", "--out", "-"}, {"standard output"}},
      {{"measure", "@s.ply", "@o.ply", "--json", "@o.ply"}, {"--json", "SIMPLIFIED", "o.ply"}},
      {{"info", "@s.ply", "--json", "@link.ply"}, {"--json", "MESH", "s.ply"}},
      {{"batch", "@keep.txt", "--out", "-", "--ratio", "0.5"}, {"standard output"}}};
  for (const auto& [words, named] : cases) {
    const auto done = given.run(words);
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK(done.out.empty());
    for (const std::string& name : named) CHECK_THAT(done.err, Contains(name));
    CHECK(given.all_files() == before);
  }
}

TEST_CASE("standard output that is a file counts as that file") {
  const Given given;
  const std::string script = given.folder / "run.sh";
  std::ofstream(script) << "cd '" << given.folder.path().string()
                        << "' && exec '" WHITTLE_PROGRAM
                           "' simplify s.ply out.ply --ratio 0.5 --json - >out.ply\n";
  const auto done = programs::run("/bin/bash", {script});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("OUT and --json would both be written to"));
}

TEST_CASE("a failure of one output keeps all others away") {
  const Given given;
  const auto before = given.all_files();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"simplify", "@s.ply", "@o.ply", "--ratio", "0.5", "--map", "/dev/full"},
        {"simplify", "@s.ply", "@o.ply", "--ratio", "0.5", "--map", "@m", "--json", "/dev/full"},
        {"lods", "@s.ply", "--levels", "3", "--out", "@l.ply", "--json", "/dev/full"}}) {
    const auto done = given.run(words);
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK_THAT(done.err, Contains("/dev/full: No space left on device"));
    CHECK(given.all_files() == before);
  }
}

TEST_CASE("the map may go to standard output") {
  const Given given;
  const auto done = given.run({"simplify", "@s.ply", "@o.ply", "--ratio", "0.5", "--map", "-"});
  CHECK(done.code == 0);
  CHECK(std::count(done.out.begin(), done.out.end(), '\n') == 40);
  CHECK_FALSE(fs::exists("-"));
}

TEST_CASE("lods of a GLB leaves the model and writes all levels beside it") {
  const Given given;
  files::write_mesh(given.folder / "m.glb", meshes::torus(8, 5));
  const std::string model = programs::contents(given.folder / "m.glb");
  CHECK(given.run({"lods", "@m.glb", "--levels", "2", "--quiet"}).code == 0);
  CHECK(programs::contents(given.folder / "m.glb") == model);
  CHECK_THAT(programs::contents(given.folder / "m-lods.glb"), Contains("MSFT_lod"));
}

TEST_CASE("names that are not UTF-8 are read and written, and JSON stays JSON") {
  const Given given;
  const std::string name = "caf\xe9.ply";
  std::ofstream(given.folder / name)
      << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty float \xff\nelement face 4\n"
         "property list uchar int vertex_indices\nend_header\n"
         "0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const auto done = given.run({"simplify", "@" + name, "@out" + name, "--faces", "4", "--json", "@r.json"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("not written: property '\\xff'"));
  CHECK_THAT(done.out, Contains("outcaf\\xe9.ply"));
  CHECK_THAT(Json::parse(programs::contents(given.folder / "r.json"))["input"]["file"].get<std::string>(),
             Contains("caf\xEF\xBF\xBD.ply"));
  CHECK(Json::parse(given.run({"info", "@" + name, "--json", "-"}).out)["mesh"]["faces"] == 4);
}

TEST_CASE("names with control characters reach neither the terminal nor another line") {
  const Given given;
  const std::string name = "a\x1b[31m\nwhittle: done.ply";
  for (const std::string& file : {name, "missing" + name}) {
    if (file == name) files::write_mesh(given.folder / file, meshes::tetrahedron());
    const auto done = given.run({"info", "@" + file});
    CHECK(done.code == (file == name ? 0 : 2));
    CHECK_THAT(done.out + done.err, Contains("a\\x1b[31m\\nwhittle: done.ply"));
    CHECK((done.out + done.err).find('\x1b') == std::string::npos);
    CHECK(done.error_lines() == (file == name ? 0u : 1u));
  }
}

TEST_CASE("a selection without an end is refused") {
  const Given given;
  const auto done =
      given.run({"simplify", "@s.ply", "@o.ply", "--ratio", "0.5", "--lock", "selection:/dev/zero"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("/dev/zero: neither a file nor a pipe"));
}
