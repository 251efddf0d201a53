/// \file
/// glTF: as written, and documents by hand.
#include <nlohmann/json.hpp>

#include "files/Scene.hh"
#include "files/bytes.hh"
#include "gltf_samples.hh"
#include "meshes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

TEST_CASE("GLB: meshes are written chunk by chunk as expected") {
  const Folder folder;
  write_mesh(folder / "a.glb", square(), {},
             {square_normals(), square_colours(true, false), square_texture(), scalar("q", {1, 2, 3, 4})});
  const std::string bytes = folder.get("a.glb");
  CHECK(bytes.substr(0, 4) == "glTF");
  CHECK(load<std::uint32_t>(bytes.data() + 4, ByteOrder::little) == 2);
  CHECK(load<std::uint32_t>(bytes.data() + 8, ByteOrder::little) == bytes.size());
  const Json json = json_of(bytes);
  CHECK(json["asset"]["version"] == "2.0");
  const Json part = json["meshes"][0]["primitives"][0];
  CHECK(part["mode"] == 4);
  const Json accessor = json["accessors"][part["attributes"]["POSITION"].get<std::size_t>()];
  CHECK(accessor["count"] == 4);
  CHECK(accessor["min"] == Json{0.0, 0.0, 0.0});
  CHECK(accessor["max"] == Json{1.0, 1.0, 0.5});
  const Json colour = json["accessors"][part["attributes"]["COLOR_0"].get<std::size_t>()];
  CHECK(colour["componentType"] == 5121);
  CHECK(colour["normalized"] == true);
  CHECK(json["accessors"][part["indices"].get<std::size_t>()]["componentType"] == 5123);
  CHECK(part["attributes"].contains("_q"));
  for (const Json& view : json["bufferViews"]) CHECK(view.value("byteOffset", 0) % 4 == 0);
}

TEST_CASE("GLB: many vertices take wider indices") {
  const Folder folder;
  const IndexedMesh mesh = strip<float>(70000);
  write_mesh(folder / "a.glb", mesh);
  CHECK(same_bits<float>(read_mesh(folder / "a.glb").mesh, mesh));
}

TEST_CASE("GLB: a seam splits vertices in the file, and closes again when it is read") {
  const Folder folder;
  const IndexedMesh mesh = rounded(meshes::torus(12, 8));
  // Every face has texture coordinates of its own.
  Attribute texture = attribute(Kind::texture, 2, {});
  texture.downwards = true;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    texture.corners.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    for (int k = 0; k < 6; ++k) texture.values.push_back(static_cast<float>(6 * i) + static_cast<float>(k));
  }
  const MeshFile back = folder.there_and_back("a.glb", mesh, {texture});
  CHECK(same_bits<double>(back.mesh, mesh));
  CHECK(back.report.merged_vertices == 3 * mesh.triangles.size() - mesh.points.size());
  CHECK(back.report.nonmanifold_edges == 0);
  REQUIRE(back.attributes.size() == 1);
  CHECK(same_attribute(back.attributes[0], texture, mesh));
}

TEST_CASE("GLB: vertices of no face, and points alone") {
  const Folder folder;
  IndexedMesh mesh = square();
  mesh.points.emplace_back(7, 7, 7);
  Attribute normal = square_normals();
  normal.values.insert(normal.values.end(), {0, 1, 0});
  const MeshFile back = folder.there_and_back("a.glb", mesh, {normal});
  CHECK(same_bits<double>(back.mesh, square()));
  CHECK(same_attribute(back.attributes.at(0), square_normals(), square()));
  mesh.triangles.clear();
  const MeshFile points = folder.there_and_back("a.glb", mesh, {normal});
  CHECK(same_bits<double>(points.mesh, mesh));
  CHECK(same_attribute(points.attributes.at(0), normal, mesh));
}

TEST_CASE("GLB: normals get unit length, unless they are nothing") {
  const Folder folder;
  const Attribute normal =
      attribute(Kind::normal, 3, {0, 0, 3, 0, 0.6F, 0.8F, 0, 0, 0, 0.57735F, 0.57735F, 0.57735F});
  CHECK(folder.there_and_back("a.glb", square(), {normal}).attributes.at(0).values ==
        std::vector<float>{0, 0, 1, 0, 0.6F, 0.8F, 0, 0, 0, 0.57735F, 0.57735F, 0.57735F});
}

TEST_CASE("glTF: a document with its data inside") {
  const Folder folder;
  const MeshFile file = folder.read("a.gltf", gltf_text(gltf_square()));
  CHECK(file.report.format == "glTF, JSON");
  CHECK(file.report.notes().empty());
  CHECK(file.single_precision);
  CHECK(same_bits<double>(file.mesh, square()));
  CHECK(folder.read("a.glb", glb_of(gltf_square())).report.format == "glTF, binary");
  CHECK(folder.read("a.obj", gltf_text(gltf_square())).report.format == "glTF, JSON");
}

TEST_CASE("glTF: transforms of nodes, one above the other") {
  const Folder folder;
  Json json = gltf_square();
  json["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}},
                   {{"mesh", 0}, {"scale", {2, 2, 2}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}}};
  const MeshFile file = folder.read("a.gltf", gltf_text(json));
  CHECK((file.mesh.points[1] - IndexedMesh::Point(10, 2, 0)).norm() < 1e-12);
  CHECK((file.mesh.points[3] - IndexedMesh::Point(8, 0, 1)).norm() < 1e-12);
  CHECK(file.mesh.triangles == square().triangles);
  CHECK_FALSE(file.single_precision);
  const Attribute& normal = find(file.attributes, Kind::normal);
  CHECK(std::abs(normal.values[3] + 0.6F) < 1e-6F);  // (0, 0.6, 0.8) turned by 90 degrees
  CHECK(std::abs(normal.values[5] - 0.8F) < 1e-6F);

  json["nodes"] = {{{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}};
  const MeshFile mirrored = folder.read("a.gltf", gltf_text(json));
  CHECK(mirrored.mesh.points[1] == IndexedMesh::Point(4, 6, 7));
  CHECK(mirrored.mesh.triangles == Triangles{{0, 2, 1}, {0, 3, 2}});
  CHECK(find(mirrored.attributes, Kind::normal).values[6] == -1);

  json["nodes"] = {{{"mesh", 0}, {"scale", {1, 1, 0}}}};  // has no inverse
  CHECK(find(folder.read("a.gltf", gltf_text(json)).attributes, Kind::normal).values[2] == 1);
}

TEST_CASE("glTF: a mesh is shown by each of a node's instances") {
  const Folder folder;
  GltfBuilder built = square_builder();
  const int places = built.floats({0, 0, 0, 10, 0, 0}, "VEC3", 3);
  const int turns = built.floats({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4);
  const int scales = built.floats({1, 1, 1, 3, 3, 3}, "VEC3", 3);
  Json& attributes = built.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes = {{"TRANSLATION", places}, {"ROTATION", turns}, {"SCALE", scales}};
  built.json["nodes"][0]["translation"] = {0, 5, 0};
  built.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const MeshFile file = folder.read("a.gltf", gltf_text(built.json));
  CHECK(file.report.ignored.empty());
  REQUIRE(file.mesh.points.size() == 8);
  CHECK(file.mesh.points[2] == IndexedMesh::Point(square().points[2] + IndexedMesh::Point(0, 5, 0)));
  CHECK((file.mesh.points[6] - IndexedMesh::Point(7, 2, 3 * square().points[2][2])).norm() < 1e-6);

  // As part of a scene it counts as large as its largest instance.
  ReadOptions options;
  options.keep_scene = true;
  CHECK(read_mesh(folder / "a.gltf", options).scene->placements.at(0).scale == Approx(3));
  attributes["SCALE"] = built.floats({1, 1, 1}, "VEC3", 3);
  CHECK(folder.error("a.gltf", gltf_text(built.json)) == "a.gltf: instances have values of different number");
  attributes = {{"SCALE", turns}};
  CHECK(folder.error("a.gltf", gltf_text(built.json)) == "a.gltf: instances have values of the wrong kind");
  attributes = {{"SCALE", -1}};
  CHECK(folder.error("a.gltf", gltf_text(built.json)) == "a.gltf: its JSON is damaged: wrong 'SCALE'");
}

TEST_CASE("glTF: parts are joined, and what they lack is made up for") {
  const Folder folder;
  Json json = gltf_square();
  json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}, {{"mesh", 1}}};
  json["scenes"][0]["nodes"] = {0, 1, 2};
  json["meshes"][1] = json["meshes"][0];
  json["meshes"][1]["primitives"][0]["attributes"].erase("NORMAL");
  const MeshFile file = folder.read("a.gltf", gltf_text(json));
  CHECK(file.report.parts == 3);
  CHECK(file.mesh.points.size() == 12);  // they touch, but have no edge in common
  CHECK(file.mesh.triangles.size() == 6);
  CHECK(file.report.missing_values == 4);
  CHECK(file.report.notes()[0] == "3 parts of the scene joined into one mesh");
  CHECK(file.report.vertices_apart == 9);
}

TEST_CASE("glTF: strips, fans and no indices") {
  const Folder folder;
  Json json = gltf_square();
  Json& part = json["meshes"][0]["primitives"][0];
  const auto triangles = [&] { return folder.read("a.gltf", gltf_text(json)).mesh.triangles; };
  part.erase("indices");
  part["mode"] = 5;
  CHECK(triangles() == Triangles{{0, 1, 2}, {1, 3, 2}});
  part["mode"] = 6;
  CHECK(triangles() == Triangles{{1, 2, 0}, {2, 3, 0}});
  part["mode"] = 4;
  CHECK(folder.error("a.gltf", gltf_text(json)) == "a.gltf: a number of corners that makes no triangles");
  part["mode"] = 1;
  CHECK(folder.read("a.gltf", gltf_text(json)).report.ignored == Names{"lines"});
  part["mode"] = 9;
  CHECK(folder.error("a.gltf", gltf_text(json)) == "a.gltf: a part of an unknown kind");
}

TEST_CASE("glTF: what is not read is named") {
  const Folder folder;
  Json json = gltf_square();
  json["materials"] = {{{"name", "red"}}};
  json["images"] = {{{"uri", "missing.png"}}};
  json["textures"] = {{{"source", 0}}};
  json["animations"] = Json::array({Json::object()});
  json["cameras"] = Json::array({Json::object()});
  json["extras"] = {{"a", 1}};
  json["scenes"].push_back(Json::object());
  json["nodes"][0]["extensions"] = {{"EXT_x", Json::object()}};
  Json& part = json["meshes"][0]["primitives"][0];
  part["attributes"]["TEXCOORD_1"] = part["attributes"]["POSITION"];
  part["targets"] = Json::array({Json::object()});
  part["material"] = 0;
  const ReadReport report = folder.read("a.gltf", gltf_text(json)).report;
  CHECK(report.ignored == Names{"other scenes", "extension 'EXT_x'"});
  CHECK(report.ignored_besides ==
        Names{"animations", "cameras", "extras", "morph targets", "attribute 'TEXCOORD_1'"});
  CHECK_THAT(report.notes().back(), Catch::Matchers::Contains("'EXT_x', animations, cameras"));
  CHECK_THAT(report.notes_on_shape().back(), !Catch::Matchers::Contains("animations"));
}

TEST_CASE("glTF: without scenes all nodes count, without nodes all meshes") {
  const Folder folder;
  Json json = gltf_square();
  json.erase("scenes");
  json.erase("scene");
  json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}, {"translation", {1, 0, 0}}}};
  CHECK(folder.read("a.gltf", gltf_text(json)).mesh.points[0] == IndexedMesh::Point(1, 0, 0));
  json.erase("nodes");
  CHECK(same_bits<double>(folder.read("a.gltf", gltf_text(json)).mesh, square()));
}

TEST_CASE("glTF: integers that stand for numbers, strides and sparse values") {
  const Folder folder;
  GltfBuilder built;
  // Positions as shorts with two more bytes behind each; one of them is replaced.
  std::string shorts;
  for (const int number : {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0})
    append_little(shorts, static_cast<std::int16_t>(number));
  const int points = built.view(shorts, 8);
  std::string replaced;
  for (const int number : {5, 6, 7}) append_little(replaced, static_cast<std::int16_t>(number));
  const int indices = built.view(std::string("\2", 1)), values = built.view(replaced);
  built.json["accessors"] = {{{"bufferView", points},
                              {"componentType", 5122},
                              {"type", "VEC3"},
                              {"count", 3},
                              {"sparse",
                               {{"count", 1},
                                {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                {"values", {{"bufferView", values}}}}}}};
  built.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  built.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
  const MeshFile file = folder.read("a.gltf", gltf_text(built.json));
  CHECK(file.mesh.points == std::vector<IndexedMesh::Point>{{0, 0, 0}, {1, 0, 0}, {5, 6, 7}});
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
}

}  // namespace
}  // namespace whittle::files
