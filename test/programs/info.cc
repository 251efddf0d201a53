#include <nlohmann/json.hpp>

#include "Process.hh"
#include "files/MeshFile.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

TEST_CASE("info counts what is in a file") {
  const programs::Folder folder;
  files::write_mesh(folder / "torus.ply", meshes::torus(12, 8));
  const auto text = programs::run(WHITTLE_PROGRAM, {"info", folder / "torus.ply"});
  CHECK(text.code == 0);
  CHECK_THAT(text.out, Contains("Euler characteristic   0"));
  const auto done = programs::run(WHITTLE_PROGRAM, {"info", folder / "torus.ply", "--json", "-"});
  const Json mesh = Json::parse(done.out)["mesh"];
  CHECK(mesh["vertices"] == 96);
  CHECK(mesh["faces"] == 192);
  CHECK(mesh["edges"] == 288);
  CHECK(mesh["closed"] == true);
  CHECK(mesh["components"] == 1);
}

TEST_CASE("info reports what the reader changed or left out") {
  const programs::Folder folder;
  std::ofstream(folder / "quad.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2\nf 1 2 3 4\n";
  const auto done =
      programs::run(WHITTLE_PROGRAM, {"info", folder / "quad.obj", "--json", folder / "i.json"});
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("lines"));
  const Json read = Json::parse(programs::contents(folder / "i.json"))["read"];
  CHECK(read["polygons_split"] == 1);
  CHECK(read["attributes_ignored"] == Json::array({"lines"}));
  CHECK(programs::run(WHITTLE_PROGRAM, {"info", folder / "quad.obj", "--quiet"}).err.empty());
}

TEST_CASE("info tells the attributes of a file, and how many charts its texture has") {
  const programs::Folder folder;
  const IndexedMesh mesh = meshes::flat_grid(3);
  using attributes::Kind;
  attributes::Attribute whole{Kind::texture, "", 2, false, false, {}, {}},
      tiles = whole, colour{Kind::colour, "", 3, true, false, {}, {}};
  for (const auto& p : mesh.points) {
    whole.values.insert(whole.values.end(), {static_cast<float>(p.x()), static_cast<float>(p.y())});
    colour.values.insert(colour.values.end(), {1, 0, 0});
  }
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    tiles.corners.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    for (std::uint32_t k = 0; k < 3; ++k)
      tiles.values.insert(tiles.values.end(), {static_cast<float>(f), static_cast<float>(k)});
  }
  const auto told = [&](const attributes::Attributes& given) {
    files::write_mesh(folder / "in.ply", mesh, {}, given);
    const auto done = programs::run(WHITTLE_PROGRAM, {"info", folder / "in.ply", "--json", folder / "json"});
    CHECK(done.code == 0);
    return std::pair(done.out, Json::parse(programs::contents(folder / "json"))["attributes"]);
  };
  CHECK(told({}).second == Json::array());
  const auto [text, one] = told({whole, colour});
  CHECK_THAT(text, Contains("texture coordinates    9 at vertices, 1 chart\n") &&
                       Contains("colours                9 at vertices\n"));
  REQUIRE(one.size() == 2);
  const auto [tiled_text, tiled] = told({tiles});
  CHECK_THAT(tiled_text, Contains("texture coordinates    24 at corners, 8 charts\n"));
  CHECK(tiled == Json::array({{{"name", "texture coordinates"},
                               {"at", "corners"},
                               {"components", 2},
                               {"values", 24},
                               {"charts", 8}}}));
}

TEST_CASE("info and measure count the faces that intersect, and list them") {
  const programs::Folder folder;
  IndexedMesh pierced =
      meshes::flat_grid(2);  // two faces, and one that goes through the first and touches the second
  const auto first = static_cast<std::uint32_t>(pierced.points.size());
  for (const double z : {-1.0, 1.0}) pierced.points.emplace_back(0.75, 0.25, z);
  pierced.points.emplace_back(0.5, 0.5, 0);
  pierced.triangles.push_back({first, first + 1, first + 2});
  files::write_mesh(folder / "pierced.off", pierced);
  files::write_mesh(folder / "clean.off", meshes::tetrahedron());

  const auto text = programs::run(WHITTLE_PROGRAM, {"info", folder / "pierced.off"});
  CHECK_THAT(text.out, Contains("intersecting pairs     2\n"));
  const auto counted = programs::run(WHITTLE_PROGRAM, {"info", folder / "pierced.off", "--json", "-"});
  CHECK(Json::parse(counted.out)["intersections"] == Json({{"pairs", 2}, {"all", true}}));
  const auto listed = programs::run(WHITTLE_PROGRAM, {"measure", folder / "clean.off", folder / "pierced.off",
                                                      "--list-intersections", "--json", "-"});
  const Json json = Json::parse(listed.out);
  CHECK(json["original"]["intersections"] == Json({{"pairs", 0}, {"all", true}, {"list", Json::array()}}));
  CHECK(json["simplified"]["intersections"]["list"] == Json::parse("[[0, 2], [1, 2]]"));
  const auto table =
      programs::run(WHITTLE_PROGRAM, {"measure", folder / "clean.off", folder / "pierced.off"});
  CHECK_THAT(table.out, Contains("intersecting pairs                  0              2\n"));
}

TEST_CASE("info refuses a file that is no mesh") {
  const programs::Folder folder;
  std::ofstream(folder / "poem.ply") << "the fog comes\n";
  for (const std::string name : {"none.ply", "poem.ply", ""}) {
    const auto done = programs::run(WHITTLE_PROGRAM, {"info", folder / name});
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK(done.out.empty());
  }
}
