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
