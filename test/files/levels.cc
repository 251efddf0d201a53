/// \file
/// Levels of detail in one GLB.
#include "files/levels.hh"

#include "files/Scene.hh"
#include "gltf_samples.hh"
#include "meshes.hh"

namespace whittle::files {
namespace {

TEST_CASE("write_levels: the first level is the scene, the others hang on it") {
  const Folder folder;
  const std::vector<Level> levels{{meshes::torus(24, 16), {}, {}, 0},
                                  {meshes::torus(12, 8), {}, {}, 0.01},
                                  {square(), {square_normals()}, {}, 1}};
  const WriteReport report = write_levels(folder / "a.glb", levels);
  CHECK(report.notes().empty());

  const Json json = json_of(folder.get("a.glb"));
  CHECK(json["extensionsUsed"] == Json{"MSFT_lod"});
  CHECK(json["scenes"][0]["nodes"] == Json{0});
  CHECK(json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] == Json{1, 2});
  CHECK(json["nodes"][0]["extras"]["error"] == 0);
  CHECK(json["nodes"][2]["extras"]["error"] == 1);
  const Json coverage = json["nodes"][0]["extras"]["MSFT_screencoverage"];
  REQUIRE(coverage.size() == 3);
  CHECK(coverage[0].get<double>() > coverage[1].get<double>());
  CHECK(coverage[0].get<double>() < 1);
  CHECK(coverage[2] == 0);

  const MeshFile first = read_mesh(folder / "a.glb");
  CHECK(same_bits<float>(first.mesh, levels[0].mesh));
  CHECK(first.report.ignored == Names{"2 coarser levels of detail"});
}

TEST_CASE("write_levels: no coverage where errors do not grow, no extension for one level") {
  const Folder folder;
  write_levels(folder / "a.glb", {{square(), {}, {}, 0}, {square(), {}, {}, 0}});
  CHECK_FALSE(json_of(folder.get("a.glb"))["nodes"][0]["extras"].contains("MSFT_screencoverage"));
  CHECK(read_mesh(folder / "a.glb").report.ignored.front() == "1 coarser level of detail");
  write_levels(folder / "b.glb", {{square(), {}, {}, 0}});
  CHECK_FALSE(json_of(folder.get("b.glb")).contains("extensionsUsed"));
  CHECK(read_mesh(folder / "b.glb").report.notes().empty());
}

TEST_CASE("write_levels: a .gltf has the data of all levels in one file beside it") {
  const Folder folder;
  write_levels(folder / "a.gltf", {{meshes::torus(12, 8), {}, {}, 0}, {square(), {}, {}, 1}});
  CHECK(folder.entries() == 2);
  const Json json = Json::parse(folder.get("a.gltf"));
  CHECK(json["buffers"] == Json{{{"byteLength", folder.get("a.bin").size()}, {"uri", "a.bin"}}});
  CHECK(json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] == Json{1});
  CHECK(read_mesh(folder / "a.gltf").mesh.triangles.size() == 192);
}

TEST_CASE("write_levels refuses what write_mesh would") {
  const Folder folder;
  const auto error = [&](const std::vector<Level>& levels) {
    return folder.message([&] { write_levels(folder / "a.glb", levels); });
  };
  CHECK(error({}) == "a.glb: not written: there is no level of detail");
  CHECK(error({{square(), {}, {}, NAN}}) == "a.glb: not written: an error that is not finite");
  IndexedMesh bad = square();
  bad.triangles.push_back({0, 1, 9});
  CHECK(error({{square(), {}, {}, 0}, {bad, {}, {}, 1}}) ==
        "a.glb: not written: a triangle names a vertex that is not there");
  CHECK(folder.entries() == 0);
}

/// Two meshes, of four faces and of one, in five nodes: two that show the first and are nothing else, the second of them
/// skinned; one that shows it and has a child, instances and a light; that child, which shows the second mesh; a joint.
/// The first mesh has a morph target, and lines.
Json scene_to_be_levelled() {
  GltfBuilder built;
  Json& json = built.json;
  const int points = built.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0}, "VEC3", 3);
  const int moved = built.floats(std::vector<float>(18, 0.5F), "VEC3", 3);
  const int strip =
      built.accessor(built.view(std::string("\0\1\2\2\1\3\2\3\4\4\3\5", 12)), 5121, "SCALAR", 12);
  const int one = built.accessor(built.view(std::string("\0\1\2", 3)), 5121, "SCALAR", 3);
  const int line = built.accessor(built.view(std::string("\0\1", 2)), 5121, "SCALAR", 2);
  const int places = built.floats({0, 0, 0, 9, 9, 9}, "VEC3", 3);
  const int times = built.floats({0, 1}, "SCALAR", 1);
  const int weights = built.floats({0, 1}, "SCALAR", 1);
  json["meshes"] = {
      {{"name", "strip"},
       {"primitives",
        {{{"attributes", {{"POSITION", points}}}, {"indices", strip}, {"targets", {{{"POSITION", moved}}}}},
         {{"attributes", {{"POSITION", points}}}, {"indices", line}, {"mode", 1}}}}},
      {{"primitives", {{{"attributes", {{"POSITION", points}}}, {"indices", one}}}}}};
  json["nodes"] = {{{"mesh", 0}, {"name", "alone"}, {"translation", {7, 0, 0}}, {"extras", {{"price", 3}}}},
                   {{"mesh", 0}, {"skin", 0}, {"translation", {8, 0, 0}}},
                   {{"mesh", 0},
                    {"name", "parent"},
                    {"scale", {2, 2, 2}},
                    {"children", {3}},
                    {"extensions",
                     {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}},
                      {"KHR_lights_punctual", {{"light", 0}}}}}},
                   {{"mesh", 1}},
                   {{"name", "joint"}}};
  json["skins"] = {{{"joints", {4}}}};
  json["animations"] = {{{"channels",
                          {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}},
                           {{"sampler", 0}, {"target", {{"node", 2}, {"path", "weights"}}}},
                           {{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                         {"samplers", {{{"input", times}, {"output", weights}}}}}};
  json["scenes"] = {{{"nodes", {0, 1, 2, 4}}}};
  json["scene"] = 0;
  json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  return json;
}

TEST_CASE(
    "encode_scene_levels: each node that shows a mesh gets levels of it, and each mesh is there once a "
    "level") {
  const Folder folder;
  folder.put("a.gltf", gltf_text(scene_to_be_levelled()));
  ReadOptions options;
  options.keep_scene = true;
  const MeshFile file = read_mesh(folder / "a.gltf", options);
  REQUIRE(file.parts.of_face == std::vector<std::uint32_t>{0, 0, 0, 0, 1});
  CHECK_FALSE(has_levels(file));
  std::vector<std::uint32_t> same(file.mesh.points.size());
  for (std::uint32_t v = 0; v < same.size(); ++v) same[v] = v;
  IndexedMesh half = file.mesh, none = file.mesh;
  half.triangles.erase(half.triangles.begin(), half.triangles.begin() + 2);
  none.triangles.erase(none.triangles.begin(), none.triangles.begin() + 4);
  const std::vector<std::uint32_t> half_parts = {0, 0, 1}, none_parts = {1};
  const double scale = file.scene->placements[0].scale;
  const auto write = [&](const std::string& name) {
    Encoded out = encode_scene_levels(folder / name, file,
                                      {{{file.mesh, file.attributes, file.parts.of_face, same}, {}},
                                       {{half, file.attributes, half_parts, same}, {0.5, 0}},
                                       {{none, file.attributes, none_parts, same}, {2 * scale, 0}}});
    folder.put(name, out.bytes);
    for (const Companion& companion : out.companions)
      folder.put(companion.path.filename().string(), companion.bytes);
  };
  write("b.glb");
  const Json json = json_of(folder.get("b.glb"));

  // The second level of the first mesh is its lines alone. The second mesh has no levels, as it stays what it is.
  REQUIRE(json["meshes"].size() == 4);
  const auto count = [&](std::size_t mesh, std::size_t part) {
    return json["accessors"][json["meshes"][mesh]["primitives"][part]["indices"].get<std::size_t>()]["count"];
  };
  CHECK(count(0, 0) == 12);
  CHECK(count(1, 0) == 3);
  CHECK(count(2, 0) == 6);
  CHECK(json["meshes"][2]["name"] == "strip");
  CHECK(json["meshes"][2]["primitives"][0]["targets"].size() == 1);
  CHECK(json["meshes"][2]["primitives"][1] == json["meshes"][0]["primitives"][1]);
  REQUIRE(json["meshes"][3]["primitives"].size() == 1);
  CHECK(json["meshes"][3]["primitives"][0]["mode"] == 1);

  // Five nodes, one new child, and three times two levels.
  const Json& nodes = json["nodes"];
  REQUIRE(nodes.size() == 12);
  CHECK(json["scenes"] == scene_to_be_levelled()["scenes"]);
  CHECK(nodes[0]["extensions"]["MSFT_lod"]["ids"] == Json{5, 6});
  CHECK(nodes[0]["extras"]["price"] == 3);
  CHECK(nodes[0]["extras"]["MSFT_screencoverage"].size() == 3);
  CHECK(nodes[5] == Json{{"mesh", 2},
                         {"name", "alone_LOD1"},
                         {"translation", {7, 0, 0}},
                         {"extras", {{"error", 0.5 / scale}}}});
  CHECK(nodes[6]["mesh"] == 3);
  CHECK(nodes[6]["extras"]["error"] == Approx(2));
  CHECK(nodes[1]["extensions"]["MSFT_lod"]["ids"] == Json{7, 8});
  CHECK(nodes[1]["translation"] == Json{8, 0, 0});
  CHECK(nodes[7] == Json{{"mesh", 2}, {"skin", 0}, {"extras", {{"error", 0.5 / scale}}}});
  CHECK_FALSE(nodes[2].contains("mesh"));
  CHECK(nodes[2]["children"] == Json{3, 9});
  CHECK(nodes[2]["extensions"] == Json{{"KHR_lights_punctual", {{"light", 0}}}});
  CHECK(nodes[9]["mesh"] == 0);
  CHECK(nodes[9]["extensions"]["MSFT_lod"]["ids"] == Json{10, 11});
  CHECK(nodes[10]["extensions"] ==
        Json{{"EXT_mesh_gpu_instancing", nodes[9]["extensions"]["EXT_mesh_gpu_instancing"]}});
  CHECK(nodes[3] == Json{{"mesh", 1}});
  CHECK(json["extensionsUsed"] == Json{"EXT_mesh_gpu_instancing", "MSFT_lod"});

  // What animates the weights of a node does so for its levels.
  std::vector<std::size_t> animated;
  for (const Json& channel : json["animations"][0]["channels"])
    animated.push_back(channel["target"]["node"].get<std::size_t>());
  CHECK(animated == std::vector<std::size_t>{0, 5, 6, 9, 10, 11, 1});

  write("c.gltf");
  CHECK(Json::parse(folder.get("c.gltf"))["nodes"] == nodes);
  CHECK(folder.get("b.glb").find(folder.get("c.bin")) != std::string::npos);
  CHECK(has_levels(read_mesh(folder / "b.glb", options)));
}

}  // namespace
}  // namespace whittle::files
