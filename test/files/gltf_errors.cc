/// \file
/// glTF documents that are wrong, each in one way.
#include <functional>

#include "gltf_samples.hh"

namespace whittle::files {
namespace {

/// The message for the square after a change.
std::string error_of(const std::function<void(Json&)>& change) {
  const Folder folder;
  Json json = gltf_square();
  change(json);
  return folder.error("a.gltf", gltf_text(json));
}

TEST_CASE("glTF: accessors and views out of bounds are refused") {
  const std::string beyond = "a.gltf: an accessor reaches beyond its data";
  CHECK(error_of([](Json&) {}).empty());
  CHECK(error_of([](Json& j) { j["accessors"][0]["count"] = 5; }) == beyond);
  CHECK(error_of([](Json& j) { j["accessors"][0]["count"] = 4000000000000000000U; }) ==
        "a.gltf: the scene is too many times as large as the file");
  CHECK(error_of([](Json& j) { j["accessors"][0]["byteOffset"] = 4; }) == beyond);
  CHECK(error_of([](Json& j) { j["accessors"][0]["byteOffset"] = 18446744073709551615U; }) == beyond);
  CHECK(error_of([](Json& j) { j["bufferViews"][0]["byteLength"] = 47; }) == beyond);
  for (const char* list : {"accessors", "bufferViews"})
    for (const Json& wrong : {Json(-4), Json(1.5), Json("0"), Json(nullptr)}) {
      INFO(list << " " << wrong);
      CHECK(error_of([&](Json& j) { j[list][0]["byteOffset"] = wrong; }) ==
            "a.gltf: its JSON is damaged: wrong 'byteOffset'");
    }
  CHECK(error_of([](Json& j) { j["accessors"][0]["normalized"] = 1; }) ==
        "a.gltf: its JSON is damaged: wrong 'normalized'");
  CHECK(error_of([](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = -4; }) ==
        "a.gltf: its JSON is damaged: wrong 'mode'");
  CHECK(error_of([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = -1; }) ==
        "a.gltf: its JSON is damaged: wrong 'attributes'");
  CHECK(error_of([](Json& j) { j["bufferViews"][0]["byteStride"] = 16; }) == beyond);
  CHECK(error_of([](Json& j) { j["bufferViews"][0]["byteStride"] = 4; }) ==
        "a.gltf: values that lie closer than they are long");
  CHECK(error_of([](Json& j) { j["bufferViews"][0]["byteLength"] = 1000; }) ==
        "a.gltf: the file is cut off: a view reaches beyond its buffer");
  CHECK(error_of([](Json& j) { j["bufferViews"][0]["byteOffset"] = 18446744073709551615U; }) ==
        "a.gltf: the file is cut off: a view reaches beyond its buffer");
  CHECK(error_of([](Json& j) { j["buffers"][0]["byteLength"] = 1000; }) ==
        "a.gltf: the file is cut off: a buffer is longer than its data");
  CHECK(error_of([](Json& j) { j["bufferViews"][0]["buffer"] = 1; }) == "a.gltf: a buffer that is not there");
  CHECK(error_of([](Json& j) {
          j["accessors"][0].erase("bufferView");
          j["accessors"][0]["count"] = 100000;
        }) == "a.gltf: values that are not in the file");
}

TEST_CASE("glTF: references to missing objects are refused") {
  CHECK(error_of([](Json& j) { j["nodes"][0]["mesh"] = 1; }) == "a.gltf: its JSON is damaged: wrong 'mesh'");
  CHECK(error_of([](Json& j) { j["nodes"][0]["mesh"] = -1; }) == "a.gltf: its JSON is damaged: wrong 'mesh'");
  CHECK(error_of([](Json& j) { j["nodes"][0]["mesh"] = "0"; }) ==
        "a.gltf: its JSON is damaged: wrong 'mesh'");
  CHECK(error_of([](Json& j) { j["scenes"][0]["nodes"] = {1}; }) ==
        "a.gltf: its JSON is damaged: wrong 'nodes'");
  CHECK(error_of([](Json& j) { j["scene"] = 7; }) == "a.gltf: its JSON is damaged: wrong 'scene'");
  CHECK(error_of([](Json& j) { j["nodes"] = 3; }) == "a.gltf: its JSON is damaged: wrong 'nodes'");
  CHECK(error_of([](Json& j) {
          j["nodes"][0]["matrix"] = {1, 2};
        }) == "a.gltf: its JSON is damaged: wrong 'matrix'");
  CHECK(error_of([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }) ==
        "a.gltf: a part without positions");
  CHECK(error_of([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 7; }) != "");
  CHECK(error_of([](Json& j) { j["accessors"][1]["count"] = 3; }) ==
        "a.gltf: attributes that are not as many as the vertices");
  CHECK(error_of([](Json& j) {
          j["accessors"][2]["componentType"] = 5126;
          j["accessors"][2]["count"] = 1;
        }) == "a.gltf: indices that are not unsigned integers");
}

TEST_CASE("glTF: nodes in cycles or with two parents are refused") {
  const std::string twice = "a.gltf: its JSON is damaged: a node is there twice";
  CHECK(error_of([](Json& j) { j["nodes"][0]["children"] = {0}; }) == twice);
  CHECK(error_of([](Json& j) { j["scenes"][0]["nodes"] = {0, 0}; }) == twice);
  CHECK(error_of([](Json& j) {
          j["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}};
        }) == twice);
}

TEST_CASE("glTF: an index out of range is refused") {
  const Folder folder;
  Json json = gltf_square();
  std::string text = gltf_text(json);
  // The last of the indices: 3 becomes 7.
  GltfBuilder built;
  built.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
  built.accessor(built.view(std::string("\0\1\2\0\1\7", 6)), 5121, "SCALAR", 6);
  built.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  CHECK(folder.error("a.gltf", gltf_text(built.json)) ==
        "a.gltf: vertex index 7 is out of range: there are 3 vertices");
  const MeshFile fixed = folder.read("a.gltf", gltf_text(built.json), Repair::fix);
  CHECK(fixed.report.broken_faces == 1);
  CHECK(fixed.mesh.triangles == Triangles{{0, 1, 2}});
}

TEST_CASE("glTF: unknown versions and required extensions are refused") {
  CHECK(error_of([](Json& j) { j["asset"]["version"] = "1.0"; }) ==
        "a.gltf: glTF version '1.0' is not supported");
  CHECK(error_of([](Json& j) { j.erase("asset"); }) == "a.gltf: not glTF: it does not say its version");
  CHECK(error_of([](Json& j) { j["extensionsRequired"] = {"KHR_gaussian_splatting"}; }) ==
        "a.gltf: it needs the extension 'KHR_gaussian_splatting', which is not supported");
  CHECK(error_of([](Json& j) { j["extensionsRequired"] = {"KHR_materials_unlit"}; }).empty());
  CHECK(error_of([](Json& j) { j["extensionsRequired"] = 1; }) ==
        "a.gltf: its JSON is damaged: 'extensionsRequired' is no list");
}

TEST_CASE("glTF: data outside the file are refused") {
  CHECK(
      error_of([](Json& j) { j["buffers"][0]["uri"] = "../a.bin"; }) ==
      "a.gltf: its data are refused: '../a.bin', which leads out of its folder; only files in its folder are "
      "read");
  CHECK(error_of([](Json& j) { j["buffers"][0]["uri"] = "data:text/plain,abc"; }) ==
        "a.gltf: its data are not in base64");
  CHECK(error_of([](Json& j) { j["buffers"][0]["uri"] = "data:;base64,?"; }) == "a.gltf: damaged base64");
  CHECK(error_of([](Json& j) { j["buffers"][0].erase("uri"); }) ==
        "a.gltf: the file is cut off: a buffer is longer than its data");
}

TEST_CASE("glTF: malformed JSON is refused") {
  const Folder folder;
  const auto error = [&](const std::string& text) { return folder.error("a.gltf", text); };
  CHECK(error("{") == "a.gltf: its JSON is damaged");
  CHECK(error("[]") == "a.gltf: its JSON is damaged");
  CHECK(error("{\"a\": 1e999}") == "a.gltf: its JSON is damaged");
  CHECK(error("{\"a\": \"\xff\"}") == "a.gltf: its JSON is damaged");
  CHECK(error(std::string(100000, '[')) == "a.gltf: its JSON is nested too deeply");
  CHECK(error("{\"a\":" + std::string(100, '[')) == "a.gltf: its JSON is nested too deeply");
  CHECK(error("{\"a\":\"" + std::string(100, '[') + "\"}") ==
        "a.gltf: not glTF: it does not say its version");
}

TEST_CASE("GLB: a damaged container is refused") {
  const Folder folder;
  const auto error = [&](std::string bytes, std::size_t at, const std::string& with) {
    return folder.error("a.glb", bytes.replace(at, with.size(), with));
  };
  const std::string good = glb_of(gltf_square());
  CHECK(error(good, 0, "glTF").empty());
  CHECK(error(good, 0, "gltf") == "a.glb: not a GLB file: it does not begin with 'glTF'");
  CHECK(error(good, 4, "\1") == "a.glb: glTF version 1 is not supported");
  CHECK(error(good, 8, "\xff\xff\xff") == "a.glb: the file is cut off");
  CHECK(error(good, 8, std::string("\1\0\0\0", 4)) == "a.glb: the file is cut off");
  CHECK(error(good, 8, std::string("\x10\0\0\0", 4)) == "a.glb: the file is cut off: it has no JSON");
  CHECK(error(good, 16, "BIN") == "a.glb: expected JSON");
  CHECK(error(good, 12, "\xff\xff\xff") == "a.glb: the file is cut off");
  CHECK(folder.error("a.glb", "glTF") == "a.glb: the file is cut off: too short for a GLB header");
  CHECK(folder.read("a.glb", good + "x").report.ignored == Names{"bytes after the last chunk"});
}

TEST_CASE("glTF: a scene far larger than its file is refused") {
  const Folder folder;
  Json json = gltf_square();
  json["accessors"][0]["count"] = 4;
  // The same mesh ten thousand times takes a dozen bytes each.
  json["nodes"] = Json::array();
  for (int i = 0; i < 10000; ++i) json["nodes"].push_back({{"mesh", 0}});
  json.erase("scenes");
  json.erase("scene");
  CHECK(folder.error("a.gltf", gltf_text(json)).empty());
  GltfBuilder built;
  built.floats(std::vector<float>(3 * 10000), "VEC3", 3);
  built.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"mode", 0}}}}}};
  for (int i = 0; i < 2000; ++i) built.json["nodes"].push_back({{"mesh", 0}});
  CHECK(folder.error("a.gltf", gltf_text(built.json)) ==
        "a.gltf: the scene is too many times as large as the file");
}

TEST_CASE("glTF: parts of nothing, shown over and over again") {
  const Folder folder;
  GltfBuilder built;
  built.accessor(built.view("1234"), 5126, "VEC3", 0);
  const Json part = {{"attributes", {{"POSITION", 0}}}, {"mode", 0}};
  for (int i = 0; i < 3000; ++i) {
    built.json["meshes"][0]["primitives"].push_back(part);
    built.json["nodes"].push_back({{"mesh", 0}});
  }
  CHECK(folder.error("a.gltf", gltf_text(built.json)) ==
        "a.gltf: the scene is too many times as large as the file");
}

}  // namespace
}  // namespace whittle::files
