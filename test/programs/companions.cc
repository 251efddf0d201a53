/// \file
/// What stands beside inputs and results: libraries, images, data. Nothing is written over it, and no result loses it.
#include <map>
#include <nlohmann/json.hpp>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::whittle_program;
namespace fs = std::filesystem;

namespace {

const std::string kPng = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(30, '\7');

/// A scene with its data and an image beside it, and an OBJ file with a library that names another.
struct Companies {
  programs::Folder folder;

  Companies() {
    files::write_mesh(folder / "scene.gltf", meshes::torus(8, 5));
    Json json = Json::parse(programs::contents(folder / "scene.gltf"));
    json["images"] = {{{"uri", "skin.png"}}};
    json["asset"]["generator"] = "another program";
    std::ofstream(folder / "scene.gltf") << json.dump();
    std::ofstream(folder / "a.mtl") << "newmtl one\nKd 1 0 0\nmap_Kd skin.png\nmap_Bump bump.png\n";
    for (const char* name : {"skin.png", "bump.png"}) std::ofstream(folder / name) << kPng;
    std::ofstream(folder / "a.obj") << "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl one\n"
                                       "f 1 2 3\nf 1 3 4\n";
  }
  std::map<std::string, std::string> all_files() const {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      if (entry.is_regular_file())
        out[entry.path().lexically_relative(folder.path())] = programs::contents(entry.path());
    return out;
  }
  /// Words that begin with @ are files of the folder.
  programs::Outcome run(std::vector<std::string> words) const {
    for (std::string& word : words)
      if (word[0] == '@') word = folder / word.substr(1);
    return whittle_program(words);
  }
  std::string buffer_of(const std::string& name) const {
    return Json::parse(programs::contents(folder / name))["buffers"][0]["uri"];
  }
};

}  // namespace

TEST_CASE("an output that leads to what an input names is refused, and nothing is changed") {
  const Companies given;
  const auto before = given.all_files();
  const std::vector<std::vector<std::string>> cases{
      {"simplify", "@scene.gltf", "@scene.bin", "--format", "glb", "--ratio", "0.5"},
      {"simplify", "@scene.gltf", "@skin.png", "--format", "ply", "--ratio", "0.5"},
      {"simplify", "@scene.gltf", "@o.glb", "--ratio", "0.5", "--map", "@scene.bin"},
      {"simplify", "@scene.gltf", "@o.stl", "--ratio", "0.5", "--json", "@scene.bin"},
      {"simplify", "@a.obj", "@a.mtl", "--format", "obj", "--ratio", "1"},
      {"simplify", "@a.obj", "@o.obj", "--ratio", "1", "--json", "@a.mtl"},
      {"simplify", "@a.obj", "@o.obj", "--ratio", "1", "--json", "@bump.png"},
      {"measure", "@a.obj", "@scene.gltf", "--json", "@a.mtl"},
      {"measure", "@a.obj", "@scene.gltf", "--json", "@scene.bin"},
      {"info", "@a.obj", "--json", "@skin.png"},
      {"lods", "@scene.gltf", "--out", "@l.glb", "--json", "@scene.bin"},
      {"batch", given.folder.path().string(), "--out", "@out", "--ratio", "0.5", "--json", "@a.mtl"},
      {"batch", given.folder.path().string(), "--out", "@out", "--ratio", "0.5", "--json", "@a.obj"}};
  for (const std::vector<std::string>& words : cases) {
    const auto done = given.run(words);
    INFO(words.back() << ": " << done.err);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK_THAT(done.err, Contains("would overwrite"));
    CHECK(given.all_files() == before);
  }
}

TEST_CASE("data of a result take another name than an image that is beside it") {
  const Companies given;
  Json json = Json::parse(programs::contents(given.folder / "scene.gltf"));
  json["images"] = {{{"uri", "r.bin"}}};
  std::ofstream(given.folder / "scene.gltf") << json.dump();
  std::ofstream(given.folder / "r.bin") << kPng;
  fs::create_directory(given.folder / "out");
  for (const std::string out : {"out/r.gltf", "r.gltf"}) {
    const auto done = given.run({"simplify", "@scene.gltf", "@" + out, "--ratio", "0.5"});
    INFO(done.err);
    CHECK(done.code == 0);
    CHECK(programs::contents((given.folder.path() / out).parent_path() / "r.bin") == kPng);
    CHECK(files::read_mesh(given.folder / out).mesh.triangles.size() == 40);
  }
}

TEST_CASE("devices have nothing beside them") {
  const Companies given;
  const auto gltf = given.run({"simplify", "@scene.gltf", "/dev/null", "--format", "gltf", "--ratio", "0.5"});
  CHECK(gltf.code == 2);
  CHECK_THAT(gltf.err, Contains("devices"));
  CHECK_FALSE(fs::exists("/dev/null.bin"));
  REQUIRE(given.run({"simplify", "@a.obj", "@b.glb", "--ratio", "1"}).code == 0);
  const auto obj = given.run({"simplify", "@b.glb", "/dev/null", "--format", "obj", "--ratio", "1"});
  CHECK(obj.code == 0);
  CHECK_THAT(obj.err, Contains("not written: materials"));
  CHECK_FALSE(fs::exists("/dev/null.mtl"));
}

TEST_CASE("an old result stays whole until the new one is there, whose data have a name of their own") {
  const Companies given;
  const auto simplify = [&](const std::string& out, const char* ratio, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"simplify", "@scene.gltf", "@" + out, "--ratio", ratio};
    words.insert(words.end(), more.begin(), more.end());
    const auto done = given.run(words);
    INFO(done.err);
    CHECK(done.code == 0);
  };
  simplify("r.gltf", "0.5");
  CHECK(given.buffer_of("r.gltf") == "r.bin");
  const std::string old = programs::contents(given.folder / "r.bin");
  simplify("r.gltf", "0.5");
  CHECK(given.buffer_of("r.gltf") == "r.bin");
  // As the caller has not moved the new one yet, the old one must still be readable.
  simplify("work.gltf", "0.25", {"--final-out", given.folder / "r.gltf"});
  CHECK(programs::contents(given.folder / "r.bin") == old);
  CHECK(files::read_mesh(given.folder / "r.gltf").mesh.triangles.size() == 40);
  fs::rename(given.folder / "work.gltf", given.folder / "r.gltf");
  CHECK(files::read_mesh(given.folder / "r.gltf").mesh.triangles.size() == 20);
  // The data of the old one go with it, but not what another program has written.
  simplify("r.gltf", "0.7");
  const std::string name = given.buffer_of("r.gltf");
  simplify("r.gltf", "0.7");
  CHECK(given.buffer_of("r.gltf") == name);
  std::size_t buffers = 0;
  for (const auto& [file, bytes] : given.all_files())
    buffers += file[0] == 'r' && fs::path(file).extension() == ".bin" ? 1 : 0;
  CHECK(buffers == 2);  // r.bin, which was left by hand, and the new one
  simplify("scene.gltf", "0.5");
  CHECK(fs::exists(given.folder / "scene.bin"));
  CHECK(given.buffer_of("scene.gltf") != "scene.bin");
}

TEST_CASE("a library that a user has made stays, and an old result's own one goes with it") {
  const Companies given;
  const std::string users = programs::contents(given.folder / "a.mtl");
  REQUIRE(given.run({"simplify", "@a.obj", "@b.glb", "--ratio", "1"}).code == 0);
  CHECK(given.run({"simplify", "@b.glb", "@a.obj", "--ratio", "1"}).code == 0);
  CHECK(programs::contents(given.folder / "a.mtl") == users);
  const files::MeshFile file = files::read_mesh(given.folder / "a.obj");
  REQUIRE(file.parts.libraries.size() == 1);
  const std::string own = file.parts.libraries[0].name;
  CHECK(own != "a.mtl");
  REQUIRE(file.parts.images.size() == 1);
  CHECK(programs::contents(file.parts.images[0].path) == kPng);
  // The same again, and then with another colour.
  CHECK(given.run({"simplify", "@b.glb", "@a.obj", "--ratio", "1"}).code == 0);
  CHECK(files::read_mesh(given.folder / "a.obj").parts.libraries[0].name == own);
  Json json;
  CHECK(given.run({"simplify", "@b.glb", "@c.gltf", "--ratio", "1"}).code == 0);
  json = Json::parse(programs::contents(given.folder / "c.gltf"));
  json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0, 1, 0, 1};
  std::ofstream(given.folder / "c.gltf") << json.dump();
  CHECK(given.run({"simplify", "@c.gltf", "@a.obj", "--ratio", "1"}).code == 0);
  CHECK_FALSE(fs::exists(given.folder / own));
  CHECK(programs::contents(given.folder / "a.mtl") == users);
  CHECK(files::read_mesh(given.folder / "a.obj").parts.materials[0].colour[1] == 1);
}

TEST_CASE("batch: what an input names has changed, so it is done again") {
  const Companies given;
  fs::create_directory(given.folder / "in");
  for (const char* name : {"scene.gltf", "scene.bin", "skin.png", "bump.png", "a.obj", "a.mtl"})
    fs::rename(given.folder / name, given.folder / (std::string("in/") + name));
  const auto statuses = [&] {
    const auto done =
        given.run({"batch", "@in", "--out", "@out", "--ratio", "0.5", "--resume", "--json", "-"});
    return Json::parse(done.out)["statuses"];
  };
  CHECK(statuses() == Json{{"done", 2}});
  CHECK(statuses() == Json{{"done before", 2}});
  std::string bytes = programs::contents(given.folder / "in/scene.bin");
  for (char& c : bytes) c = 0;
  std::ofstream(given.folder / "in/scene.bin") << bytes + "0000";
  CHECK(statuses()["done before"] == 1);
  std::ofstream(given.folder / "in/a.mtl", std::ios::app) << "# more\n";
  CHECK(statuses()["done"] == 1);
}

TEST_CASE("an image that several materials or images name is in a GLB once") {
  const Companies given;
  std::ofstream(given.folder / "a.mtl") << "newmtl one\nmap_Kd skin.png\nnewmtl two\nmap_Kd ./skin.png\n";
  std::ofstream(given.folder / "a.obj", std::ios::app) << "v 0 0 1\nusemtl two\nf 1 2 5\n";
  REQUIRE(given.run({"simplify", "@a.obj", "@b.gltf", "--ratio", "1"}).code == 0);
  Json json = Json::parse(programs::contents(given.folder / "b.gltf"));
  CHECK(json["materials"].size() == 2);
  CHECK(json["images"].size() == 1);
  CHECK(json["textures"].size() == 1);
  json = Json::parse(programs::contents(given.folder / "scene.gltf"));
  json["images"] = {{{"uri", "skin.png"}}, {{"uri", "skin.png"}}, {{"uri", "bump.png"}}};
  std::ofstream(given.folder / "scene.gltf") << json.dump();
  REQUIRE(given.run({"simplify", "@scene.gltf", "@c.glb", "--ratio", "1"}).code == 0);
  const std::string glb = programs::contents(given.folder / "c.glb");
  std::size_t copies = 0;
  for (std::size_t at = 0; (at = glb.find(kPng, at)) != std::string::npos; ++at) ++copies;
  CHECK(copies == 2);
}

TEST_CASE("libraries: quotes hold a name together, a comment is none, and ./ makes no other") {
  const Companies given;
  fs::rename(given.folder / "a.mtl", given.folder / "my lib.mtl");
  const auto libraries = [&](const std::string& statement) {
    std::ofstream(given.folder / "a.obj")
        << statement << "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl one\nf 1 2 3\n";
    const files::MeshFile file = files::read_mesh(given.folder / "a.obj");
    std::vector<std::string> names;
    for (const files::Library& library : file.parts.libraries) names.push_back(library.name);
    CHECK(file.parts.materials[0].colour[1] == 0);  // it is found
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(libraries("mtllib \"my lib.mtl\"") == Names{"my lib.mtl"});
  CHECK(libraries("mtllib my lib.mtl") == Names{"my lib.mtl"});
  CHECK(libraries("mtllib \"my lib.mtl\" other.mtl # and \"no more\"") == Names{"my lib.mtl", "other.mtl"});
  CHECK(libraries("mtllib my lib.mtl\nmtllib ./my lib.mtl\nmtllib ././my lib.mtl") == Names{"my lib.mtl"});
}

TEST_CASE(
    "measure says which file has no area to measure from, and why; and options that are empty are refused") {
  const Companies given;
  const auto file = [&](const std::string& name, const std::string& x) {
    std::ofstream(given.folder / name) << "v 0 0 0\nv " << x << " 0 0\nv 0 " << x << " 0\nf 1 2 3\n";
  };
  file("big.obj", "1e300");
  file("tiny.obj", "1e-300");
  std::ofstream(given.folder / "flat.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"big.obj", "too large"}, {"tiny.obj", "too small"}, {"flat.obj", "no face has an area"}};
  for (const auto& [name, why] : cases) {
    const auto done = given.run({"measure", "@a.obj", "@" + name});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains(name + ": " + why));
  }
  CHECK(given.run({"measure", "@a.obj", "@a.obj", "--certify", ""}).code == 2);
  CHECK(given.run({"simplify", "@a.obj", "@b.obj", "--ratio", "1", "--final-out", ""}).code == 2);
  CHECK_FALSE(fs::exists(given.folder / "b.obj"));
}
