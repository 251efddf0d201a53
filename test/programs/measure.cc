#include <nlohmann/json.hpp>

#include "Process.hh"
#include "files/MeshFile.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

TEST_CASE("measure prints the distance of two parallel squares") {
  const programs::Folder folder;
  IndexedMesh low = meshes::flat_grid(2), high = low;
  for (auto& p : high.points) p.z() = 0.25;
  files::write_mesh(folder / "low.obj", low);
  files::write_mesh(folder / "high.obj", high);
  const auto done =
      programs::run(WHITTLE_PROGRAM, {"measure", folder / "low.obj", folder / "high.obj", "--json", "-"});
  REQUIRE(done.code == 0);
  const Json json = Json::parse(done.out);
  const Json distance = json["distance"]["two_sided"];
  CHECK(distance["rms_units"].get<double>() == Approx(0.25));
  CHECK(distance["mean_units"].get<double>() == Approx(0.25));
  CHECK(distance["max_units"].get<double>() == Approx(0.25));
  CHECK(distance["max_percent_of_diagonal"].get<double>() == Approx(25 / std::sqrt(2.0)));
  CHECK(json["distance"]["flipped_faces_against_nearest"] == 0);
  CHECK(json["original"]["mesh"]["boundary_edges"] == 4);
  CHECK(json["simplified"]["mesh"]["area_square_units"].get<double>() == Approx(1));

  const auto table = programs::run(WHITTLE_PROGRAM, {"measure", folder / "low.obj", folder / "high.obj"});
  CHECK_THAT(table.out, Contains("RMS"));
  CHECK_THAT(table.out, Contains("17.6777"));
}

TEST_CASE("measure refuses what it cannot compare") {
  const programs::Folder folder;
  files::write_mesh(folder / "a.obj", meshes::tetrahedron());
  IndexedMesh points;
  points.points.emplace_back(0, 0, 0);
  files::write_mesh(folder / "empty.off", points);
  for (const auto& [arguments, culprit] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"measure", folder / "a.obj"}, "SIMPLIFIED"},
           {{"measure", folder / "a.obj", folder / "none.obj"}, "none.obj"},
           {{"measure", folder / "a.obj", folder / "empty.off"}, "face"},
           {{"measure", folder / "a.obj", folder / "a.obj", "--samples", "0"}, "--samples"}}) {
    const auto done = programs::run(WHITTLE_PROGRAM, arguments);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK_THAT(done.err, Contains(culprit));
  }
}
