/// \file
/// Materials, groups and scenes through whittle simplify.
#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "TorusFile.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::whittle_program;

namespace {

/// A plate with a disc of another material, as an OBJ file.
struct DiscFile {
  programs::Folder folder;
  IndexedMesh mesh = meshes::flat_grid(41);

  DiscFile() {
    files::Parts parts;
    parts.in_libraries = true;
    parts.libraries = {{"two.mtl", folder.path() / "two.mtl"}};
    parts.materials.resize(2);
    parts.materials[0].name = "plate";
    parts.materials[1].name = "disc";
    parts.list = {{0, "thing", "", ""}, {1, "thing", "", ""}};
    for (const auto& [a, b, c] : mesh.triangles) {
      const Eigen::Vector3d centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
      parts.of_face.push_back((centre - Eigen::Vector3d(20, 20, 0)).norm() < 12 ? 1 : 0);
    }
    files::write_mesh(folder / "in.obj", mesh, {}, {}, parts);
    std::ofstream(folder / "two.mtl") << "newmtl plate\nKd 1 0 0\nnewmtl disc\nKd 0 0 1\n";
  }

  /// What is of the disc's material.
  double disc_area(const std::string& name) const {
    const files::MeshFile file = files::read_mesh(folder / name);
    double area = 0;
    for (std::size_t f = 0; f < file.mesh.triangles.size(); ++f) {
      const std::uint32_t material = file.parts.list[file.parts.of_face[f]].material;
      if (file.parts.materials[material].name != "disc") continue;
      const auto& [a, b, c] = file.mesh.triangles[f];
      area += (file.mesh.points[b] - file.mesh.points[a])
                  .cross(file.mesh.points[c] - file.mesh.points[a])
                  .norm() /
              2;
    }
    return area;
  }
};

}  // namespace

TEST_CASE("the border between materials moves and does not melt, whatever the module") {
  const DiscFile in;
  const double before = in.disc_area("in.obj");
  for (const std::string module : {"mq", "quadric", "vtd:seams=merge", "ivdd", "fad"}) {
    INFO(module);
    const auto done = whittle_program({"simplify", in.folder / "in.obj", in.folder / "out.obj", "--ratio",
                                       "0.2", "--module", module, "--json", in.folder / "json"});
    CHECK(done.code <= 1);
    CHECK_THAT(done.out, Contains("materials in two.mtl"));
    CHECK(in.disc_area("out.obj") == Approx(before).epsilon(0.03));
    const Json json = Json::parse(programs::contents(in.folder / "json"));
    CHECK(json["charts"]["before"] == 2);
    REQUIRE(json["output"]["materials"].size() == 2);
    CHECK(json["output"]["materials"][1]["name"] == "disc");
    CHECK(json["output"]["materials"][0]["faces"].get<int>() +
              json["output"]["materials"][1]["faces"].get<int>() ==
          json["output"]["faces"]);
  }
  CHECK(whittle_program(
            {"simplify", in.folder / "in.obj", in.folder / "out.obj", "--ratio", "0.2", "--delaunay", "20"})
            .code == 0);
  CHECK(in.disc_area("out.obj") == Approx(before).epsilon(0.03));
}

TEST_CASE("PLY: the border between two images moves and does not melt") {
  const DiscFile in;
  files::MeshFile file = files::read_mesh(in.folder / "in.obj");
  file.parts.in_libraries = false;
  file.parts.images = {{"plate.png", in.folder.path() / "plate.png"},
                       {"disc.png", in.folder.path() / "disc.png"}};
  for (std::size_t i = 0; i < 2; ++i) {
    std::ofstream(file.parts.images[i].path) << "image";
    file.parts.materials[i].image = i;
    file.parts.materials[i].colour = {1, 1, 1, 1};
  }
  files::write_mesh(in.folder / "in.ply", file.mesh, {}, {}, file.parts);
  REQUIRE(in.disc_area("in.ply") == Approx(in.disc_area("in.obj")));
  const auto done = whittle_program({"simplify", in.folder / "in.ply", in.folder / "out.ply", "--ratio",
                                     "0.2", "--json", in.folder / "json"});
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK_THAT(done.out, Contains("textures plate.png, disc.png"));
  CHECK(Json::parse(programs::contents(in.folder / "json"))["charts"]["before"] == 2);
  CHECK(in.disc_area("out.ply") == Approx(in.disc_area("in.obj")).epsilon(0.03));
}

TEST_CASE("materials that are dropped, or that the format does not hold, make no seams") {
  const DiscFile in;
  const auto charts = [&](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> arguments{"simplify", in.folder / "in.obj", in.folder / out, "--ratio", "0.2",
                                       "--json",   in.folder / "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto done = whittle_program(arguments);
    INFO(done.err);
    CHECK(done.code == 0);
    return Json::parse(programs::contents(in.folder / "json"))["charts"]["before"].get<int>();
  };
  CHECK(charts("a.stl", {}) == 0);
  CHECK(charts("b.obj", {"--drop", "materials"}) == 0);
  CHECK_THAT(programs::contents(in.folder / "b.obj"), !Contains("usemtl") && Contains("o thing"));
  CHECK(charts("c.obj", {"--drop", "materials", "--seams", "groups"}) == 2);
}

TEST_CASE("lods: every level has its materials") {
  const DiscFile in;
  CHECK(whittle_program({"lods", in.folder / "in.obj", "--levels", "3", "--out", in.folder / "l.obj"}).code ==
        0);
  CHECK(in.disc_area("l-lod2.obj") == Approx(in.disc_area("in.obj")).epsilon(0.03));
  CHECK(whittle_program({"lods", in.folder / "in.obj", "--levels", "3", "--out", in.folder / "l.glb"}).code ==
        0);
  CHECK(in.disc_area("l.glb") == Approx(in.disc_area("in.obj")));
}

TEST_CASE("a scene's meshes are simplified once, together or each for itself") {
  const DiscFile in;
  REQUIRE(whittle_program({"simplify", in.folder / "in.obj", in.folder / "a.gltf", "--ratio", "0.9"}).code ==
          0);
  Json json = Json::parse(programs::contents(in.folder / "a.gltf"));
  // Three nodes show the one mesh, a fourth a part of it as a mesh of its own, ten times as large.
  json["meshes"].push_back({{"name", "disc alone"}, {"primitives", {json["meshes"][0]["primitives"][1]}}});
  json["nodes"] = {{{"mesh", 0}},
                   {{"mesh", 0}, {"translation", {90, 0, 0}}},
                   {{"mesh", 0}, {"name", "third"}},
                   {{"mesh", 1}, {"scale", {10, 10, 10}}}};
  json["scenes"] = {{{"nodes", {0, 1, 2, 3}}}};
  std::ofstream(in.folder / "a.gltf") << json.dump();
  const auto faces = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "simplify", in.folder / "a.gltf", in.folder / "b.gltf", "--ratio", "0.25",
        "--json",   in.folder / "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto done = whittle_program(arguments);
    INFO(done.err);
    CHECK(done.code == 0);
    const Json out = Json::parse(programs::contents(in.folder / "b.gltf"));
    CHECK(out["nodes"] == json["nodes"]);
    std::vector<int> counts;
    for (const Json& mesh : out["meshes"]) {
      int count = 0;
      for (const Json& part : mesh["primitives"])
        count += out["accessors"][part["indices"].get<std::size_t>()]["count"].get<int>() / 3;
      counts.push_back(count);
    }
    return counts;
  };
  const std::vector<int> together = faces({}), each = faces({"--each-mesh"});
  REQUIRE(together.size() == 2);
  REQUIRE(each.size() == 2);
  const Json report = Json::parse(programs::contents(in.folder / "json"));
  CHECK(together[0] + together[1] <= report["input"]["faces"].get<int>() / 4);
  CHECK(each[0] + each[1] == report["output"]["faces"].get<int>());
  CHECK(whittle_program(
            {"simplify", in.folder / "in.obj", in.folder / "b.glb", "--ratio", "0.2", "--each-mesh"})
            .code == 2);
  const auto flat = whittle_program({"simplify", in.folder / "a.gltf", in.folder / "c.glb", "--ratio", "0.5",
                                     "--flatten", "--json", in.folder / "json"});
  CHECK(flat.code == 0);
  CHECK(Json::parse(programs::contents(in.folder / "json"))["input"]["faces"].get<int>() >
        report["input"]["faces"].get<int>());
}

TEST_CASE("batch leaves results with all that belongs beside them, named from where they are") {
  const DiscFile in;
  namespace fs = std::filesystem;
  fs::create_directories(in.folder / "scans/deep");
  for (const char* name : {"in.obj", "two.mtl"})
    fs::copy(in.folder / name, in.folder / (std::string("scans/deep/") + name));
  REQUIRE(
      whittle_program({"simplify", in.folder / "in.obj", in.folder / "scans/deep/a.gltf", "--ratio", "0.9"})
          .code == 0);
  const auto batch = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"batch",           in.folder / "scans", "--out",
                                       in.folder / "out", "--ratio",           "0.5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto done = whittle_program(arguments);
    INFO(done.out << done.err);
    CHECK(done.code == 0);
  };
  const double area = in.disc_area("in.obj");
  batch({});
  CHECK(in.disc_area("out/deep/in.obj") == Approx(area).epsilon(0.03));
  CHECK(in.disc_area("out/deep/a.gltf") == Approx(area).epsilon(0.03));
  CHECK(fs::exists(in.folder / "out/deep/a.bin"));
  CHECK(fs::is_empty(in.folder / "out/.whittle/work"));
  CHECK_FALSE(fs::exists(in.folder / "out/deep/two.mtl"));  // it is referred to
  fs::remove_all(in.folder / "out");
  batch({"--copy-materials"});
  CHECK(fs::exists(in.folder / "out/deep/two.mtl"));
  CHECK(in.disc_area("out/deep/in.obj") == Approx(area).epsilon(0.03));
  fs::remove_all(in.folder / "out");
  fs::remove(in.folder / "scans/deep/a.gltf");
  batch({"--format", "gltf"});
  CHECK(in.disc_area("out/deep/in.gltf") == Approx(area).epsilon(0.03));
}
