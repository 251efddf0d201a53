/// \file
/// Attributes that are left out, and attributes that make seams, through whittle simplify.
#include <cmath>
#include <nlohmann/json.hpp>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::TorusFile;
using programs::whittle_program;

namespace {

attributes::Attribute at_corners(attributes::Kind kind, std::size_t components) {
  attributes::Attribute out;
  out.kind = kind;
  out.components = components;
  return out;
}

/// A torus whose every face is a chart of its own, with colours and normals at the vertices.
struct TiledFile : TorusFile {
  TiledFile() : TorusFile("in.obj") {
    attributes::Attribute texture = at_corners(attributes::Kind::texture, 2);
    attributes::Attribute colour = at_corners(attributes::Kind::colour, 3);
    attributes::Attribute normal = at_corners(attributes::Kind::normal, 3);
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      texture.corners.push_back({3 * f, 3 * f + 1, 3 * f + 2});
      const float x = static_cast<float>(f);
      texture.values.insert(texture.values.end(), {x, 0, x + 1, 0, x, 1});
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      colour.values.insert(colour.values.end(), {1, 0, static_cast<float>(v % 2)});
      normal.values.insert(normal.values.end(), {0, 0, 1});
    }
    files::write_mesh(path, mesh, {}, {texture, colour, normal});
  }

  programs::Outcome simplify(const std::string& out, std::vector<std::string> more) const {
    std::vector<std::string> arguments{"simplify", path,       folder / out,    "--ratio",
                                       "0.2",      "--module", "mq:charts=keep"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return whittle_program(arguments);
  }
  std::vector<attributes::Kind> kinds(const std::string& out) const {
    std::vector<attributes::Kind> kinds;
    for (const auto& attribute : files::read_mesh(folder / out).attributes) kinds.push_back(attribute.kind);
    return kinds;
  }
};

}  // namespace

TEST_CASE("what the output cannot hold constrains nothing, and is said to be left out") {
  const TiledFile in;
  const auto held = in.simplify("out.obj", {});
  CHECK(held.code == 1);
  CHECK_THAT(held.err, Contains("--drop texture leaves the texture out"));
  const auto done = in.simplify("out.stl", {"--json", in.folder / "json"});
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("not written: normals, colours, texture coordinates") ||
                           Contains("not written: colours, texture coordinates, normals"));
  const Json json = Json::parse(programs::contents(in.folder / "json"));
  CHECK(json["input"]["attributes"].size() == 3);
  CHECK(json["output"]["attributes_left_out"].size() == 3);
  CHECK(json["charts"]["before"] == 0);
  // Unless a module is told to weigh it.
  CHECK(in.simplify("out.stl", {"--module", "mq:charts=keep,texture=1"}).code == 2);
  CHECK(whittle_program({"simplify", in.path, in.folder / "out.stl", "--ratio", "0.2", "--module",
                         "mq:charts=keep,texture=1"})
            .code == 1);
}

TEST_CASE("--drop leaves an attribute out, with what it would constrain") {
  const TiledFile in;
  CHECK(in.simplify("out.obj", {"--drop", "texture", "--json", in.folder / "json"}).code == 0);
  CHECK(in.kinds("out.obj") == std::vector{attributes::Kind::colour, attributes::Kind::normal});
  const Json json = Json::parse(programs::contents(in.folder / "json"));
  CHECK(json["attributes_dropped"] == Json{"texture"});
  CHECK(json["output"]["attributes_left_out"].empty());
  CHECK(in.simplify("out.obj", {"--drop", "texture", "--drop", "normals", "--drop", "colours"}).code == 0);
  CHECK(in.kinds("out.obj").empty());
  const auto bad = in.simplify("out.obj", {"--drop", "smell"});
  CHECK(bad.code == 2);
  CHECK(bad.error_lines() == 1);
  CHECK_THAT(bad.err, Contains("smell"));

  // So it is in every command.
  CHECK(whittle_program({"lods", in.path, "--levels", "3", "--out", in.folder / "lods.obj", "--drop",
                         "texture", "--module", "mq:charts=keep"})
            .code == 0);
  CHECK(in.kinds("lods-lod2.obj").size() == 2);
  CHECK(whittle_program({"batch", in.folder.path().string(), "--out", in.folder / "batch", "--drop",
                         "texture", "--ratio", "0.2", "--quiet"})
            .code == 0);
  CHECK(in.kinds("batch/in.obj").size() == 2);
}

TEST_CASE("every command tells how many charts and pieces have vanished, and what to do about many") {
  const TiledFile in;  // 2,688 charts
  const programs::Folder folder;
  const std::string half = "charts of the texture have vanished; --drop texture leaves it out";
  const auto gone = [](const Json& charts) {
    CHECK(charts["before"] == 2688);
    return charts["gone"].get<std::size_t>();
  };
  const auto json = [](const std::string& file) { return Json::parse(programs::contents(file)); };
  const auto simplified = whittle_program(
      {"simplify", in.path, folder / "out.obj", "--ratio", "0.25", "--json", folder / "json"});
  CHECK(simplified.code == 0);
  CHECK_THAT(simplified.out, Contains(half));
  const std::size_t charts_gone = gone(json(folder / "json")["charts"]);
  CHECK(charts_gone > 1344);

  for (const std::vector<std::string>& module : {std::vector<std::string>{}, {"--module", "mq"}}) {
    std::vector<std::string> arguments{"lods",           in.path,  "--levels",      "3",         "--out",
                                       folder / "l.obj", "--json", folder / "json", "--samples", "100"};
    arguments.insert(arguments.end(), module.begin(), module.end());
    const auto lods = whittle_program(arguments);
    CHECK(lods.code == 0);
    CHECK_THAT(lods.out, Contains("of 2688 charts of the texture have vanished\n") && Contains(half));
    CHECK(gone(json(folder / "json")["levels"][1]["charts"]) > 0);
    CHECK(gone(json(folder / "json")["levels"][2]["charts"]) == charts_gone);
  }
  const auto batch =
      whittle_program({"batch", in.folder.path().string(), "--out", folder / "batch", "--ratio", "0.25"});
  CHECK(batch.code == 0);
  CHECK_THAT(batch.out, Contains(half));
  for (const auto& file : std::filesystem::directory_iterator(folder / "batch/.whittle/log"))
    CHECK(gone(json(file.path())["charts"]) == charts_gone);

  files::write_mesh(folder / "dusty.ply", meshes::dusty_torus(60));
  const auto pieces =
      whittle_program({"lods", folder / "dusty.ply", "--levels", "2", "--out", folder / "l.ply", "--samples",
                       "100", "--pieces", "1%", "--json", folder / "json"});
  CHECK(pieces.code == 0);
  CHECK_THAT(pieces.out, Contains("60 of 61 pieces have vanished, with 480 faces of the input"));
  const Json of_level = json(folder / "json")["levels"][1]["pieces"];
  CHECK(of_level == Json({{"rule", "1%"}, {"before", 61}, {"gone", 60}, {"faces_gone", 480}}));
}

TEST_CASE("texture coordinates and colours count by default, and how far each has changed is told") {
  // A plate with a disc that is red, and a texture that is mirrored in the middle.
  programs::Folder folder;
  const IndexedMesh mesh = meshes::flat_grid(41);
  attributes::Attribute texture = at_corners(attributes::Kind::texture, 2);
  attributes::Attribute colour = at_corners(attributes::Kind::colour, 3);
  for (const auto& p : mesh.points) {
    const float x = static_cast<float>(p.x()) / 40, y = static_cast<float>(p.y()) / 40;
    texture.values.insert(texture.values.end(), {std::abs(2 * x - 1), y});
    const bool is_red = std::hypot(x - 0.5F, y - 0.5F) < 0.3F;
    colour.values.insert(colour.values.end(), {1, is_red ? 0.0F : 1.0F, is_red ? 0.0F : 1.0F});
  }
  const auto changes = [&](const attributes::Attribute& attribute, const std::string& module) {
    files::write_mesh(folder / "in.ply", mesh, {}, {attribute});
    const auto done = whittle_program({"simplify", folder / "in.ply", folder / "out.ply", "--ratio", "0.05",
                                       "--module", module, "--json", folder / "json"});
    INFO(done.err);
    CHECK(done.code == 0);
    CHECK_THAT(done.out, Contains("attributes off by"));
    return Json::parse(programs::contents(folder / "json"))["attribute_changes"];
  };
  CHECK(changes(texture, "mq")["texture"]["rms_texels"] < 1);
  CHECK(changes(texture, "mq:texture=0")["texture"]["rms_texels"] > 10);
  CHECK(changes(colour, "mq")["colours"]["rms_255ths"] < 10);
  CHECK(changes(colour, "mq:colours=0")["colours"]["rms_255ths"] > 20);
}

TEST_CASE("lods and batch tell how far attributes have changed, in texels of the image where there is one") {
  programs::Folder folder;
  std::filesystem::create_directories(folder / "in");
  const IndexedMesh mesh = meshes::flat_grid(21);
  attributes::Attribute texture = at_corners(attributes::Kind::texture, 2);
  for (const auto& p : mesh.points)
    texture.values.insert(texture.values.end(),
                          {std::abs(static_cast<float>(p.x()) / 10 - 1), static_cast<float>(p.y()) / 20});
  files::write_mesh(folder / "in/a.obj", mesh, {}, {texture});
  const auto changes_of = [&] {
    const auto lods = whittle_program({"lods", folder / "in/a.obj", "--levels", "2", "--out",
                                       folder / "l.obj", "--samples", "100", "--json", folder / "json"});
    CHECK(lods.code == 0);
    const Json level = Json::parse(programs::contents(folder / "json"))["levels"][1];
    const auto batch = whittle_program({"batch", folder / "in", "--out", folder / "out", "--ratio", "0.5"});
    CHECK(batch.code == 0);
    for (const std::string& text : {lods.out, batch.out}) CHECK_THAT(text, Contains("attributes off by"));
    std::string log;
    for (const auto& file : std::filesystem::directory_iterator(folder / "out/.whittle/log"))
      log = programs::contents(file.path());
    std::filesystem::remove_all(folder / "out");
    const Json changes = Json::parse(log)["attribute_changes"];
    CHECK(changes["texture"]["image"] == level["attribute_changes"]["texture"]["image"]);
    return changes["texture"];
  };
  const Json of_1024 = changes_of();
  CHECK(of_1024["image"].is_null());
  std::ofstream(folder / "in/a.mtl") << "newmtl a\nmap_Kd a.png\n";
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x20\0\0\0\x20\0", 24);  // 8,192 by 8,192
  std::ofstream(folder / "in/a.png", std::ios::binary) << head;
  const std::string obj = programs::contents(folder / "in/a.obj");
  std::ofstream(folder / "in/a.obj") << "mtllib a.mtl\nusemtl a\n" << obj;
  const Json of_image = changes_of();
  CHECK(of_image["image"]["width"] == 8192);
  CHECK(of_image["max_texels"].get<double>() ==
        Approx(8 * of_1024["max_texels"].get<double>()).epsilon(0.01).margin(0.01));
}
