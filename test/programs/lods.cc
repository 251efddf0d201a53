#include <fstream>
#include <nlohmann/json.hpp>

#include "TorusFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::TorusFile;
using programs::whittle_program;

TEST_CASE("lods writes a chain of files, each half of the one before, with its error") {
  const TorusFile in;
  const auto done = whittle_program(
      {"lods", in.path, "--levels", "4", "--samples", "9000", "--out", in.folder / "out.ply", "--json", "-"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const Json json = Json::parse(done.out);
  REQUIRE(json["levels"].size() == 4);
  CHECK(json["levels"][0]["faces"] == 2688);
  double error = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    const Json& level = json["levels"][i];
    const std::string file = level["file"];
    CHECK(file == in.folder / ("out-lod" + std::to_string(i) + ".ply"));
    const auto mesh = files::read_mesh(file).mesh;
    CHECK(mesh.triangles.size() == level["faces"]);
    CHECK(mesh.triangles.size() <= 2688u >> i);
    CHECK(double(mesh.triangles.size()) >= 0.99 * double(2688u >> i));
    CHECK(measure::facts(mesh).closed());
    const double rms = level["distance"]["two_sided"]["rms_units"];
    CHECK(rms > error);
    CHECK(rms == Approx(measure::distance(in.mesh, mesh, {9000, 0}).two_sided.rms).epsilon(0.01));
    error = rms;
  }
  CHECK(files::read_mesh(in.folder / "out-lod0.ply").mesh.points.size() == in.mesh.points.size());
}

TEST_CASE("lods brings each level closer to the input by a refit, unless told otherwise") {
  const TorusFile in;
  const auto levels = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"lods",   in.path, "--levels", "4", "--out", in.folder / "out.ply",
                                   "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return Json::parse(whittle_program(words).out)["levels"];
  };
  const Json with = levels({}), without = levels({"--no-refit"});
  REQUIRE(with.size() == 4);
  for (std::size_t i = 1; i < 4; ++i) {
    const auto rms = [&](const Json& all) {
      return all[i]["distance"]["two_sided"]["rms_units"].get<double>();
    };
    CHECK(rms(with) < 0.95 * rms(without));
  }
}

TEST_CASE("lods writes one GLB with all levels") {
  const TorusFile in;
  const auto done = whittle_program(
      {"lods", in.path, "--out", in.folder / "out.glb", "--levels", "3", "--samples", "9000"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK_THAT(done.out, Contains("RMS"));
  CHECK_THAT(programs::contents(in.folder / "out.glb"), Contains("MSFT_lod"));
  CHECK(files::read_mesh(in.folder / "out.glb").mesh.triangles.size() == 2688);
}

TEST_CASE("lods takes any module, and other ratios") {
  const TorusFile in;
  const auto done = whittle_program({"lods", in.path, "--out", in.folder / "out.obj", "--levels", "3",
                                     "--samples", "900", "--ratio", "0.7", "--module", "ivdd", "--quiet"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK(done.out.empty());
  CHECK(files::read_mesh(in.folder / "out-lod1.obj").mesh.triangles.size() <= 1882);
  CHECK(files::read_mesh(in.folder / "out-lod2.obj").mesh.triangles.size() <= 1318);
}

TEST_CASE("lods reports a level out of reach, and refuses parameters out of range") {
  const TorusFile in;
  const auto short_of = whittle_program(
      {"lods", in.path, "--out", in.folder / "out.ply", "--levels", "12", "--samples", "900"});
  CHECK(short_of.code == 1);
  CHECK_THAT(short_of.err, Contains("were wanted"));
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--levels", "1"},
                                               {"--ratio", "1"},
                                               {"--module", "nothing"},
                                               {"--out", in.folder / "no/out.ply"},
                                               {"--out", in.folder / "out.xyz"}}) {
    std::vector<std::string> arguments{"lods", in.path};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto bad = whittle_program(arguments);
    INFO(more[0] << " " << more[1]);
    CHECK(bad.code == 2);
    CHECK(bad.error_lines() == 1);
  }
}

TEST_CASE("lods keeps a scene, and gives each mesh its levels once") {
  const TorusFile in;
  const std::string glb = in.folder / "torus.glb";
  REQUIRE(whittle_program({"simplify", in.path, glb, "--ratio", "1", "--quiet"}).code == 0);
  const auto json_of = [](const std::string& path) {
    const std::string bytes = programs::contents(path);
    return Json::parse(bytes.substr(0, 4) == "glTF" ? bytes.substr(20, bytes.find("BIN", 20) - 24) : bytes);
  };
  // A second node that shows the mesh.
  Json json = json_of(glb);
  json["nodes"].push_back({{"mesh", 0}, {"name", "second"}, {"translation", {9, 0, 0}}});
  json["scenes"][0]["nodes"] = {0, 1};
  const std::string whole = programs::contents(glb);
  json["buffers"][0]["uri"] = "torus.bin";
  std::ofstream(in.folder / "torus.bin", std::ios::binary) << whole.substr(whole.find("BIN", 20) + 4);
  std::ofstream(in.folder / "two.gltf") << json.dump();
  for (const std::string out : {"out.glb", "out.gltf"}) {
    const auto done = whittle_program({"lods", in.folder / "two.gltf", "--levels", "3", "--samples", "900",
                                       "--out", in.folder / out, "--json", "-"});
    INFO(done.err);
    REQUIRE(done.code == 0);
    const Json figures = Json::parse(done.out), written = json_of(in.folder / out);
    REQUIRE(written["meshes"].size() == 3);
    REQUIRE(written["nodes"].size() == 6);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto accessor = written["meshes"][i]["primitives"][0]["indices"].get<std::size_t>();
      CHECK(written["accessors"][accessor]["count"] == 3 * figures["levels"][i]["faces"].get<std::size_t>());
    }
    CHECK(figures["levels"][1]["faces"] == 1344);
    CHECK(written["nodes"][1]["name"] == "second");
    CHECK(written["nodes"][1]["extensions"]["MSFT_lod"]["ids"].size() == 2);
    const auto again = whittle_program({"lods", in.folder / out, "--out", in.folder / "again.glb"});
    CHECK(again.code == 2);
    CHECK_THAT(again.err, Contains("has levels of detail already"));
    CHECK(files::read_mesh(in.folder / out).mesh.triangles.size() == 2 * 2688);
  }
}

TEST_CASE("lods: levels that are no coarser than the one before are said") {
  const programs::Folder folder;
  files::write_mesh(folder / "a.ply", meshes::flat_grid(3));
  const auto done = whittle_program(
      {"lods", folder / "a.ply", "--out", folder / "l.glb", "--levels", "6", "--ratio", "0.5"});
  INFO(done.err);
  CHECK_THAT(done.err, Catch::Matchers::Contains("levels that have as many faces as the one before: 4, 5"));
  CHECK_THAT(whittle_program({"lods", folder / "a.ply", "--out", folder / "l.glb", "--levels", "3"}).err,
             !Catch::Matchers::Contains("as many faces"));
}
