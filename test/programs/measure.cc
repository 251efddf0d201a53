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

TEST_CASE("measure certifies the distance over all points") {
  const programs::Folder folder;
  // Samples do not meet the needle.
  IndexedMesh low = meshes::flat_grid(3), high = low;
  const auto first = static_cast<std::uint32_t>(high.points.size());
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0.3, 0.4, 0), Eigen::Vector3d(0.3, 0.4, 0.25), Eigen::Vector3d(0.3001, 0.4, 0.125)})
    high.points.push_back(p);
  high.triangles.push_back({first, first + 1, first + 2});
  files::write_mesh(folder / "low.obj", low);
  files::write_mesh(folder / "high.obj", high);
  const std::vector<std::string> command{"measure", folder / "low.obj", folder / "high.obj", "--certify",
                                         "0.1%"};
  auto with_json = command;
  with_json.insert(with_json.end(), {"--json", "-"});
  const auto done = programs::run(WHITTLE_PROGRAM, with_json);
  REQUIRE(done.code == 0);
  const Json certified = Json::parse(done.out)["certified"];
  const double lower = certified["lower_units"], upper = certified["upper_units"];
  CHECK(lower <= 0.25);
  CHECK(upper >= 0.25);
  CHECK(upper - lower <= 0.001 * std::sqrt(2.0));
  CHECK(certified["farthest_on"] == "simplified");
  CHECK(certified["farthest_units"][2].get<double>() == Approx(0.25).margin(0.002));
  CHECK_THAT(programs::run(WHITTLE_PROGRAM, command).out, Contains("max, proved: at least"));

  const auto plain =
      programs::run(WHITTLE_PROGRAM, {"measure", folder / "low.obj", folder / "high.obj", "--json", "-"});
  CHECK(Json::parse(plain.out)["certified"].is_null());
  for (const std::string wrong : {"0", "-1", "1x", "1e-20"}) {
    const auto refused = programs::run(
        WHITTLE_PROGRAM, {"measure", folder / "low.obj", folder / "high.obj", "--certify", wrong});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err,
               Contains("whittle: ") && Contains(wrong == "1x" || wrong == "-1" ? wrong : "tolerance"));
  }
}

TEST_CASE("measure prints how far a texture has slid") {
  const programs::Folder folder;
  const IndexedMesh mesh = meshes::flat_grid(2);
  attributes::Attribute texture{attributes::Kind::texture, "", 2, false, false, {0, 0, 1, 0, 0, 1, 1, 1}, {}};
  files::write_mesh(folder / "a.obj", mesh, {}, {texture});
  for (std::size_t i = 0; i < texture.values.size(); i += 2) texture.values[i] += 0.25f;
  files::write_mesh(folder / "b.obj", mesh, {}, {texture});
  const auto done = programs::run(
      WHITTLE_PROGRAM, {"measure", folder / "a.obj", folder / "b.obj", "--texels", "100", "--json", "-"});
  REQUIRE(done.code == 0);
  const Json slid = Json::parse(done.out)["texture"];
  CHECK(slid["rms_texels"].get<double>() == Approx(25));
  CHECK(slid["max_texels"].get<double>() == Approx(25));
  CHECK(slid["texels_across"] == 100);
  CHECK(slid["charts"] == 1);
  CHECK(slid["charts_left"] == 1);
  CHECK_THAT(
      programs::run(WHITTLE_PROGRAM, {"measure", folder / "a.obj", folder / "b.obj"}).out,
      Contains("texture, RMS and max") && Contains("256") && Contains("texels of 1,024; 1 of 1 charts"));
  // As simplify has them: texels of the original's image.
  std::ofstream(folder / "a.mtl") << "newmtl a\nmap_Kd a.png\n";
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x08\0\0\0\x04\0", 24);  // 2,048 by 1,024
  std::ofstream(folder / "a.png", std::ios::binary) << head;
  const std::string obj = programs::contents(folder / "a.obj");
  std::ofstream(folder / "a.obj") << "mtllib a.mtl\nusemtl a\n" << obj;
  const auto on_image = programs::run(
      WHITTLE_PROGRAM, {"measure", folder / "a.obj", folder / "b.obj", "--json", folder / "json"});
  CHECK_THAT(on_image.out, Contains("512") && Contains("texels of 2048 x 1024; 1 of 1 charts"));
  const Json of_image = Json::parse(programs::contents(folder / "json"))["texture"];
  CHECK(of_image["max_texels"].get<double>() == Approx(512));
  CHECK(of_image["image"] == Json({{"width", 2048}, {"height", 1024}}));

  texture.values.assign(8, 0.5f);
  files::write_mesh(folder / "flat.obj", mesh, {}, {texture});
  const auto flat =
      programs::run(WHITTLE_PROGRAM, {"measure", folder / "flat.obj", folder / "b.obj", "--json", "-"});
  CHECK(flat.code == 0);
  CHECK(Json::parse(flat.out)["texture"].is_null());
  CHECK_THAT(flat.err, Contains("no area"));
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
