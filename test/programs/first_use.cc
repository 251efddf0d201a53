/// \file
/// What somebody tries who does not know the program yet, and what it says then.
#include <nlohmann/json.hpp>
#include <sstream>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::TorusFile;
using programs::whittle_program;
namespace fs = std::filesystem;

namespace {

/// What a run that is refused says, in one line.
std::string refusal(const std::vector<std::string>& arguments) {
  const auto done = whittle_program(arguments);
  INFO(done.err);
  CHECK(done.code == 2);
  CHECK(done.error_lines() == 1);
  return done.err;
}

/// A plate of two materials with a library that names an image which is not there, and normals.
void put_plate(const fs::path& folder) {
  std::ofstream(folder / "two.mtl") << "newmtl red\nKd 1 0 0\nmap_Kd gone.png\nnewmtl blue\n";
  std::ofstream obj(folder / "plate.obj");
  obj << "mtllib two.mtl\no plate\n";
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) obj << "v " << x << " " << y << " 0\n";
  obj << "vn 0 0 1\n";
  for (int y = 0; y < 8; ++y) {
    if (y % 4 == 0) obj << (y == 0 ? "usemtl red\n" : "usemtl blue\ng far\n");
    for (int x = 0; x < 8; ++x) {
      const int v = 9 * y + x + 1;
      obj << "f " << v << "//1 " << v + 1 << "//1 " << v + 10 << "//1\nf " << v << "//1 " << v + 10 << "//1 "
          << v + 9 << "//1\n";
    }
  }
}

}  // namespace

TEST_CASE("a ratio is a number or percents, and a number of percents is told how to be written") {
  const TorusFile in;
  const std::string out = in.folder / "out.ply";
  REQUIRE(whittle_program({"simplify", in.path, out, "--ratio", "25%"}).code == 0);
  CHECK(files::read_mesh(out).mesh.triangles.size() == 672);
  CHECK_THAT(refusal({"simplify", in.path, out, "--ratio", "10"}),
             Contains("10 % of the faces is 0.1 or 10%"));
  CHECK_THAT(refusal({"simplify", in.path, out, "--ratio", "half"}), Contains("as 0.1 or 10%, not 'half'"));
}

TEST_CASE("words are understood in other spellings, and those that are not known are named") {
  const TorusFile in;
  const std::string out = in.folder / "out.ply";
  for (const char* word : {"textures", "colors", "color", "normal", "material"})
    CHECK(whittle_program({"simplify", in.path, out, "--ratio", "0.5", "--drop", word}).code == 0);
  CHECK_THAT(refusal({"simplify", in.path, out, "--target", "0.1"}),
             Contains("there is no option --target;"));
  CHECK_THAT(refusal({"simplify", in.path, out, "more", "--ratio", "0.1"}),
             Contains("'more' is one word too many"));
  CHECK_THAT(whittle_program({"--help"}).out, Contains("3MF, glTF)"));
}

TEST_CASE("a folder that is missing is told") {
  const TorusFile in;
  const std::string deep = in.folder / "no/such/out.ply";
  CHECK_THAT(refusal({"simplify", in.path, deep, "--ratio", "0.5"}),
             Contains("out.ply: its folder does not exist; make it first"));
}

TEST_CASE("modules are listed by a command of their own, and in the manual, not in each help") {
  CHECK_THAT(whittle_program({"modules"}).out, Contains("ivdd: ") && Contains("normal-flipping: "));
  CHECK_THAT(whittle_program({"manual"}).out, Contains("normal\\-flipping: "));
  CHECK_THAT(whittle_program({"simplify", "--help"}).out,
             !Contains("normal-flipping: ") && Contains("whittle modules"));
}

TEST_CASE("files beside a result are listed, also of glTF; a missing image is told, also with --quiet") {
  const programs::Folder folder;
  put_plate(folder.path());
  const auto done =
      whittle_program({"simplify", folder / "plate.obj", folder / "out.gltf", "--ratio", "0.5"});
  CHECK_THAT(done.out, Contains("written beside: out.bin"));
  CHECK_THAT(done.err, Contains("plate.obj: not found: gone.png"));
  const auto quiet =
      whittle_program({"simplify", folder / "plate.obj", folder / "q.obj", "--ratio", "0.5", "--quiet"});
  CHECK(quiet.out.empty());
  CHECK(quiet.error_lines() == 1);
  CHECK_THAT(quiet.err, Contains("not found: gone.png"));
}

TEST_CASE(
    "info tells materials, objects, groups and the scene, and what measures shapes is not told of looks") {
  const programs::Folder folder;
  put_plate(folder.path());
  const auto told = [&](const std::string& name) {
    const auto done = whittle_program({"info", folder / name, "--json", folder / "json"});
    CHECK(done.code == 0);
    return std::pair(done, Json::parse(programs::contents(folder / "json"))["contents"]);
  };
  const auto [obj, in_obj] = told("plate.obj");
  CHECK_THAT(obj.out, Contains("2: red (64 faces), blue (64 faces)") && Contains("1: plate (128 faces)") &&
                          Contains("1: far (64 faces)"));
  CHECK(in_obj["libraries"] == Json::array({"two.mtl"}));
  CHECK(in_obj["scene"].is_null());

  REQUIRE(whittle_program({"simplify", folder / "plate.obj", folder / "a.gltf", "--ratio", "1"}).code == 0);
  Json json = Json::parse(programs::contents(folder / "a.gltf"));
  json["nodes"] = {{{"mesh", 0}, {"name", "here"}},
                   {{"mesh", 0}, {"name", "there"}, {"translation", {0, 0, 5}}}};
  json["scenes"] = {{{"nodes", {0, 1}}}};
  json["cameras"] = {
      {{"type", "perspective"}, {"name", "eye"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  std::ofstream(folder / "a.gltf") << json.dump();
  const auto [gltf, in_gltf] = told("a.gltf");
  CHECK(gltf.err.find("not read") == std::string::npos);
  CHECK_THAT(gltf.out, Contains("faces                  256") &&
                           Contains("each mesh once: 81 vertices, 128 faces") && Contains("2: here, there") &&
                           Contains("shown by 2 nodes") && Contains("1: eye"));
  CHECK(in_gltf["scene"]["faces"] == 128);
  CHECK(in_gltf["scene"]["nodes_with_mesh"] == 2);
  const auto measured =
      whittle_program({"measure", folder / "a.gltf", folder / "a.gltf", "--samples", "100"});
  CHECK(measured.err.find("cameras") == std::string::npos);
  CHECK_THAT(whittle_program({"simplify", folder / "a.gltf", folder / "b.obj", "--ratio", "1"}).err,
             Contains("not read: cameras"));
}

TEST_CASE("batch tells what simplify would tell of each mesh, and names a broken one once") {
  const programs::Folder folder;
  fs::create_directories(folder / "in");
  put_plate(folder.path() / "in");
  std::ofstream(folder / "in/broken.ply") << "ply\nformat ascii 1.0\nend\n";
  const auto done = whittle_program({"batch", folder / "in", "--out", folder / "out", "--format", "stl",
                                     "--ratio", "0.5", "--json", folder / "json"});
  CHECK(done.code == 1);
  const std::string broken = folder / "in/broken.ply";
  CHECK_THAT(done.err, Contains("whittle: " + broken + ": failed: line 3: "));
  CHECK(done.err.find("whittle: ", 1) == std::string::npos);
  // The rows stand together, the rest below.
  const std::size_t rows = done.out.find("plate.obj  "), below = done.out.find("plate.obj:\n");
  REQUIRE(below != std::string::npos);
  CHECK(rows < below);
  CHECK_THAT(done.out, Contains("\n  not written: ") && Contains("\n  not found: gone.png\n"));
  const Json told = Json::parse(programs::contents(folder / "json"));
  for (const Json& mesh : told["meshes"]) {
    const bool is_broken = mesh["in"] == broken;
    if (is_broken) CHECK(mesh["message"].get<std::string>().rfind("line 3: ", 0) == 0);
    if (!is_broken) CHECK(mesh["message"].is_null());
    if (!is_broken) CHECK(mesh["notes"].dump().find("not written: materials") != std::string::npos);
  }
}

TEST_CASE("lods: names without an extension, folders, formats, and lists of levels") {
  const TorusFile in;
  fs::create_directories(in.folder / "e");
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"lods", in.path, "--samples", "500"});
    const auto done = whittle_program(more);
    INFO(done.err);
    CHECK(done.code == 0);
    return done.out;
  };
  const auto faces = [&](const std::string& name) {
    return files::read_mesh(in.folder / name).mesh.triangles.size();
  };
  run({"--levels", "2", "--out", in.folder / "e/l"});
  CHECK(faces("e/l-lod1.ply") == 1344);
  const std::string table = run({"--ratio", "0.25,10%", "--out", in.folder / "e/", "--format", "obj"});
  const std::string stem = fs::path(in.path).stem().string();
  CHECK(faces("e/" + stem + "-lod1.obj") == 672);
  CHECK(faces("e/" + stem + "-lod2.obj") == 268);
  CHECK_FALSE(fs::exists(in.folder / ("e/" + stem + "-lod3.obj")));
  CHECK_THAT(table, Contains("-lod0.obj\n    1"));  // no line between rows
  run({"--faces", "1000,500", "--out", in.folder / "e/f.glb"});
  CHECK_THAT(programs::contents(in.folder / "e/f.glb"), Contains("\"ids\":[1,2]"));
  const std::vector<std::string> begin{"lods", in.path, "--out", in.folder / "e/x.ply"};
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--ratio", "0.1,0.2"},
                                               {"--ratio", "1"},
                                               {"--faces", "100,0"},
                                               {"--faces", "100,x"},
                                               {"--ratio", "0.5,0.2", "--levels", "5"},
                                               {"--ratio", "0.5", "--faces", "100"}}) {
    std::vector<std::string> words = begin;
    words.insert(words.end(), more.begin(), more.end());
    INFO(more[0] << more[1]);
    refusal(words);
  }
}

TEST_CASE("3MF to 3MF: unit and object names stay; to another format the unit is told") {
  const TorusFile in;
  files::Parts parts;
  parts.list = {{files::Part::none, "knob", "", ""}};
  parts.of_face.assign(in.mesh.triangles.size(), 0);
  files::WriteOptions options;
  options.unit = "inch";
  files::write_mesh(in.folder / "a.3mf", in.mesh, options, {}, parts);
  REQUIRE(
      whittle_program({"simplify", in.folder / "a.3mf", in.folder / "b.3mf", "--ratio", "0.5"}).err.empty());
  const files::MeshFile back = files::read_mesh(in.folder / "b.3mf");
  CHECK(back.unit == "inch");
  CHECK(back.parts.list.at(0).object == "knob");
  CHECK_THAT(whittle_program({"simplify", in.folder / "a.3mf", in.folder / "b.stl", "--ratio", "0.5"}).err,
             Contains("not written: the unit, 'inch'"));
}

TEST_CASE("glTF: the vertices that are told are those that are written") {
  const programs::Folder folder;
  put_plate(folder.path());
  const auto done = whittle_program({"simplify", folder / "plate.obj", folder / "a.gltf", "--ratio", "1"});
  REQUIRE(done.code == 0);
  // A second mesh that uses the same buffers for one of its two parts.
  Json json = Json::parse(programs::contents(folder / "a.gltf"));
  Json part = json["meshes"][0]["primitives"][0];
  json["meshes"][0]["primitives"].push_back(part);
  json["meshes"][0]["primitives"][2]["indices"] = json["accessors"].size();
  Json few = json["accessors"][part["indices"].get<std::size_t>()];
  few["count"] = 3;
  json["accessors"].push_back(few);
  std::ofstream(folder / "a.gltf") << json.dump();
  const auto written = whittle_program(
      {"simplify", folder / "a.gltf", folder / "b.gltf", "--ratio", "1", "--json", folder / "json"});
  REQUIRE(written.code <= 1);
  const Json report = Json::parse(programs::contents(folder / "json"));
  const Json out = Json::parse(programs::contents(folder / "b.gltf"));
  std::size_t count = 0;
  for (const Json& piece : out["meshes"][0]["primitives"])
    count += out["accessors"][piece["attributes"]["POSITION"].get<std::size_t>()]["count"].get<std::size_t>();
  CHECK(report["output"]["vertices"].get<std::size_t>() +
            report["output"]["vertices_doubled"].get<std::size_t>() ==
        count);
  REQUIRE(whittle_program({"simplify", folder / "a.gltf", folder / "b.obj", "--ratio", "1"}).code <= 1);
  const files::MeshFile obj = files::read_mesh(folder / "b.obj");
  std::vector<bool> used(obj.mesh.points.size(), false);
  for (const auto& triangle : obj.mesh.triangles)
    for (const std::uint32_t v : triangle) used[v] = true;
  CHECK(std::find(used.begin(), used.end(), false) == used.end());
}

TEST_CASE("text has the digits of floats where the input has no more, and those of doubles else") {
  const programs::Folder folder;
  put_plate(folder.path());
  const auto longest = [&](const std::string& name) {
    std::istringstream text(programs::contents(folder / name));
    std::size_t digits = 0;
    for (std::string line; std::getline(text, line);)
      if (line.rfind("v ", 0) == 0) {
        std::istringstream numbers(line.substr(2));
        for (std::string number; numbers >> number;)
          digits = std::max(
              digits, static_cast<std::size_t>(std::count_if(number.begin(), number.end(),
                                                             [](char c) { return c >= '0' && c <= '9'; })));
      }
    return digits;
  };
  // A bump, so that vertices move to where no short number is.
  std::string text = programs::contents(folder / "plate.obj");
  text.replace(text.find("v 4 4 0"), 7, "v 4 4 1.234567");
  text.replace(text.find("v 3 4 0"), 7, "v 3.1 4 0.654321");
  std::ofstream(folder / "a.obj") << text;
  text.replace(text.find("v 4 4 1.234567"), 14, "v 4 4 1.2345678901234567");
  std::ofstream(folder / "b.obj") << text;
  for (const char* name : {"a", "b"})
    REQUIRE(whittle_program({"simplify", folder / (std::string(name) + ".obj"),
                             folder / (std::string(name) + "-out.obj"), "--ratio", "0.4"})
                .code == 0);
  CHECK(longest("a-out.obj") <= 12);  // with the zeros before and the exponent
  CHECK(longest("b-out.obj") > 14);
}
