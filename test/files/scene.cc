/// \file
/// glTF scenes: what a decimation does not change comes through.
#include "files/Scene.hh"

#include <Eigen/Geometry>

#include "gltf_samples.hh"

namespace whittle::files {
namespace {

MeshFile read_kept_scene(const Folder& folder, const std::string& name) {
  ReadOptions options;
  options.keep_scene = true;
  return read_mesh(folder / name, options);
}

/// Writes a scene back with the triangles that it has.
Encoded unchanged(const Folder& folder, const MeshFile& file, const std::string& name) {
  std::vector<std::uint32_t> map(file.mesh.points.size());
  for (std::uint32_t v = 0; v < map.size(); ++v) map[v] = v;
  Encoded out = encode_scene(folder / name, file, {file.mesh, file.attributes, file.parts.of_face, map});
  folder.put(name, out.bytes);
  for (const Companion& companion : out.companions)
    folder.put(companion.path.filename().string(), companion.bytes);
  return out;
}

/// What a scene has besides its data.
Json without_data(Json json) {
  for (const char* key :
       {"accessors", "bufferViews", "buffers", "extensionsUsed", "extensionsRequired", "asset"})
    json.erase(key);
  for (Json& mesh : json["meshes"])
    for (Json& part : mesh["primitives"])
      for (const char* key : {"attributes", "indices", "targets", "mode"}) part.erase(key);
  for (Json& skin : json["skins"]) skin.erase("inverseBindMatrices");
  for (Json& animation : json["animations"]) animation.erase("samplers");
  for (Json& image : json["images"]) image.erase("bufferView");
  return json;
}

/// A square in two parts with materials of all kinds, a mesh that two nodes show, a skin, an animation, a camera and
/// morph targets; and data that nothing names.
struct RichScene {
  GltfBuilder built;
  std::string image = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(30, '\7');

  RichScene() {
    Json& json = built.json;
    built.view(std::string(1000, 'u'));
    const int png = built.view(image);
    const int positions = built.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5F}, "VEC3", 3);
    const int texture = built.floats({0, 0, 0.5F, 0, 0.5F, 0.25F, 0, 0.1F}, "VEC2", 2);
    const int second = built.floats({0, 1, 0, 0.75F, 1, 1, 0.1F, 0.2F}, "VEC2", 2);
    const int tangents = built.floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 4);
    const int joints =
        built.accessor(built.view(std::string("\0\1\0\0\1\0\0\0\0\1\0\0\1\0\0\0", 16)), 5121, "VEC4", 4);
    const int weights =
        built.floats({0.5F, 0.5F, 0, 0, 1, 0, 0, 0, 0.25F, 0.75F, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    const int moved = built.floats({0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4}, "VEC3", 3);
    const int first = built.accessor(built.view(std::string("\0\1\2", 3)), 5121, "SCALAR", 3);
    const int other = built.accessor(built.view(std::string("\0\2\3", 3)), 5121, "SCALAR", 3);
    const int line = built.accessor(built.view(std::string("\0\1", 2)), 5121, "SCALAR", 2);
    const int times = built.floats({0, 1}, "SCALAR", 1);
    const int turns = built.floats({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4);
    std::vector<float> matrices;
    for (int i = 0; i < 32; ++i) matrices.push_back(i % 16 % 5 == 0 ? 1.0F : 0.0F);
    const int bind = built.floats(matrices, "MAT4", 16);
    const Json attributes = {{"POSITION", positions}, {"TEXCOORD_0", texture}, {"TEXCOORD_1", second},
                             {"TANGENT", tangents},   {"JOINTS_0", joints},    {"WEIGHTS_0", weights}};
    const Json targets = {{{"POSITION", moved}}};
    json["images"] = {{{"bufferView", png}, {"mimeType", "image/png"}, {"name", "skin"}}};
    json["samplers"] = {{{"wrapS", 33071}}};
    json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    json["materials"] = {
        {{"name", "transformed"},
         {"pbrMetallicRoughness",
          {{"baseColorTexture",
            {{"index", 0},
             {"extensions", {{"KHR_texture_transform", {{"scale", {2, 4}}, {"offset", {0.5, 0}}}}}}}}}}},
        {{"name", "unknown"},
         {"normalTexture", {{"index", 0}, {"texCoord", 1}}},
         {"extensions", {{"ACME_paint", {{"layers", {1, 2}}}}}},
         {"extras", {{"price", 7}}}}};
    json["meshes"] = {
        {{"name", "body"},
         {"weights", {0.5}},
         {"extras", {{"targetNames", {"smile"}}}},
         {"primitives",
          {{{"attributes", attributes}, {"indices", first}, {"material", 0}, {"targets", targets}},
           {{"attributes", attributes}, {"indices", other}, {"material", 1}, {"targets", targets}}}}},
        {{"name", "stone"},
         {"primitives",
          {{{"attributes", {{"POSITION", positions}}}, {"indices", first}},
           {{"attributes", {{"POSITION", positions}}}, {"indices", line}, {"mode", 1}}}}}};
    json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"name", "hero"}},
                     {{"mesh", 1}, {"translation", {5, 0, 0}}, {"scale", {3, 3, 3}}},
                     {{"mesh", 1}, {"rotation", {0, 0, 1, 0}}, {"children", {3}}},
                     {{"camera", 0}, {"name", "eye"}},
                     {{"name", "joint"}},
                     {{"name", "joint too"}}};
    json["skins"] = {{{"joints", {4, 5}}, {"inverseBindMatrices", bind}}};
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
    json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 4}, {"path", "rotation"}}}}}},
                           {"samplers", {{{"input", times}, {"output", turns}}}}}};
    json["scenes"] = {{{"nodes", {0, 1, 2, 4, 5}}}};
    json["extras"] = {{"owner", "me"}};
  }
};

/// What each corner of each face has: coordinates as in the file, and of all attributes, by name.
std::vector<std::string> corner_values(const MeshFile& file) {
  std::vector<std::uint32_t> in_file(file.mesh.points.size());
  for (std::uint32_t i = 0; i < file.scene->file_points.size(); ++i) {
    const std::uint32_t v = file.vertex_of.empty() ? i : file.vertex_of[i];
    if (v != MeshFile::left_out) in_file[v] = i;
  }
  std::vector<std::string> out;
  for (std::size_t face = 0; face < file.mesh.triangles.size(); ++face)
    for (std::size_t k = 0; k < 3; ++k) {
      std::string text;
      for (const double x : file.scene->file_points[in_file[file.mesh.triangles[face][k]]])
        text += std::to_string(x) + " ";
      for (const Attribute& attribute : file.attributes) {
        text += attribute.name;
        for (std::size_t i = 0; i < attribute.components; ++i)
          text += " " + std::to_string(attribute.value(attribute.at(file.mesh, face, k))[i]);
      }
      out.push_back(text);
    }
  return out;
}

Json json_in(const Folder& folder, const std::string& name) {
  const std::string bytes = folder.get(name);
  return bytes.substr(0, 4) == "glTF" ? json_of(bytes) : Json::parse(bytes);
}

}  // namespace

TEST_CASE("scene: all but the triangles' data comes through, and what nothing names goes") {
  const Folder folder;
  const RichScene rich;
  folder.put("a.gltf", gltf_text(rich.built.json));
  const MeshFile file = read_kept_scene(folder, "a.gltf");
  CHECK(file.report.ignored_besides ==
        Names{"tangents, which programs make anew from normals and texture coordinates"});
  REQUIRE(file.scene);
  CHECK(file.mesh.triangles.size() == 3);
  CHECK(file.parts.of_face == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(file.parts.areas().size() == 3);
  const Encoded out = unchanged(folder, file, "b.glb");
  CHECK(out.companions.empty());
  CHECK(without_data(json_in(folder, "b.glb")) == without_data(rich.built.json));
  CHECK(out.bytes.find(rich.image) != std::string::npos);
  CHECK(out.bytes.find(std::string(100, 'u')) == std::string::npos);

  // Once more, from what was written: every value is the same.
  const MeshFile again = read_kept_scene(folder, "b.glb");
  CHECK(again.parts.of_face == file.parts.of_face);
  CHECK(corner_values(again) == corner_values(file));
  unchanged(folder, again, "c.glb");
  CHECK(folder.get("c.glb") == folder.get("b.glb"));
}

TEST_CASE("scene: animations, skins and lines keep their data") {
  const Folder folder;
  folder.put("a.gltf", gltf_text(RichScene().built.json));
  unchanged(folder, read_kept_scene(folder, "a.gltf"), "b.gltf");
  const Json json = json_in(folder, "b.gltf");
  const std::string data = folder.get("b.bin");
  const auto float_at = [&](const Json& accessor, std::size_t i) {
    const Json& view =
        json["bufferViews"][json["accessors"][accessor.get<std::size_t>()]["bufferView"].get<std::size_t>()];
    return load<float>(data.data() + view["byteOffset"].get<std::size_t>() + 4 * i, ByteOrder::little);
  };
  CHECK(float_at(json["animations"][0]["samplers"][0]["input"], 1) == 1.0F);
  CHECK(float_at(json["animations"][0]["samplers"][0]["output"], 6) == 1.0F);
  CHECK(float_at(json["skins"][0]["inverseBindMatrices"], 5) == 1.0F);
  const Json& line = json["meshes"][1]["primitives"][1];
  CHECK(line["mode"] == 1);
  CHECK(float_at(line["attributes"]["POSITION"], 3) == 1.0F);
}

TEST_CASE("scene: each mesh is there once, as large as it is shown, apart from the others") {
  const Folder folder;
  folder.put("a.gltf", gltf_text(RichScene().built.json));
  const MeshFile file = read_kept_scene(folder, "a.gltf");
  REQUIRE(file.scene->placements.size() == 2);
  CHECK(file.scene->placements[0].scale == 1);
  CHECK(file.scene->placements[1].scale == Approx(3));
  Eigen::AlignedBox3d first, second;
  for (const auto& [box, face] : {std::pair(&first, 0), std::pair(&first, 1), std::pair(&second, 2)})
    for (const std::uint32_t v : file.mesh.triangles[static_cast<std::size_t>(face)])
      box->extend(file.mesh.points[v]);
  CHECK(first.exteriorDistance(second) >= second.diagonal().norm() / 2);
  CHECK(file.diagonal > 6);  // of the scene: a square at the origin, one of three units beside it
  CHECK(read_mesh(folder / "a.gltf").mesh.triangles.size() == 4);
}

TEST_CASE("scene: a part or a mesh that is left without faces goes, and its nodes stay") {
  const Folder folder;
  folder.put("a.gltf", gltf_text(RichScene().built.json));
  MeshFile file = read_kept_scene(folder, "a.gltf");
  IndexedMesh mesh = file.mesh;
  const std::vector<std::uint32_t> parts = {1};
  mesh.triangles = {file.mesh.triangles[1]};
  Attributes attributes = file.attributes;
  for (Attribute& attribute : attributes)
    if (!attribute.per_vertex()) attribute.corners = {attribute.corners[1]};
  const Encoded out = encode_scene(folder / "b.glb", file, {mesh, attributes, parts, {}});
  const Json json = json_of(out.bytes);
  REQUIRE(json["meshes"].size() == 2);
  CHECK(json["meshes"][0]["primitives"].size() == 1);
  CHECK(json["meshes"][0]["primitives"][0]["material"] == 1);
  CHECK(json["meshes"][1]["primitives"].size() == 1);  // the line
  CHECK(json["nodes"].size() == 6);
}

TEST_CASE(
    "scene: a texture's transform stays with its material, and other formats get it in the coordinates") {
  const Folder folder;
  folder.put("a.gltf", gltf_text(RichScene().built.json));
  const MeshFile kept = read_kept_scene(folder, "a.gltf");
  CHECK(find(kept.attributes, Kind::texture, "TEXCOORD_0").value(1)[0] == 0.5F);
  const MeshFile flat = read_mesh(folder / "a.gltf");
  const Attribute& texture = find(flat.attributes, Kind::texture);
  const float* value = texture.value(texture.at(flat.mesh, 0, 1));
  CHECK(value[0] == 2 * 0.5F + 0.5F);
  CHECK(value[1] == 0);
  value = texture.value(texture.at(flat.mesh, 0, 2));
  CHECK(value[1] == 4 * 0.25F);
}

TEST_CASE("glTF: data and images in files beside it") {
  const Folder folder;
  RichScene rich;
  Json json = rich.built.json;
  json["buffers"][0]["uri"] = "some%20data.bin";
  folder.put("some data.bin", rich.built.buffer);
  json["images"] = {{{"uri", "skin.png"}}};
  folder.put("skin.png", rich.image);
  folder.put("a.gltf", json.dump());
  const MeshFile file = read_kept_scene(folder, "a.gltf");
  CHECK(file.mesh.triangles.size() == 3);

  std::filesystem::create_directories(folder / "out");
  const Encoded glb =
      encode_scene(folder / "out/b.glb", file, {file.mesh, file.attributes, file.parts.of_face, {}});
  CHECK(glb.companions.empty());
  CHECK(glb.bytes.find(rich.image) != std::string::npos);
  CHECK(json_of(glb.bytes)["images"][0]["mimeType"] == "image/png");
  const Encoded text =
      encode_scene(folder / "out/b.gltf", file, {file.mesh, file.attributes, file.parts.of_face, {}});
  REQUIRE(text.companions.size() == 2);
  CHECK(text.companions[0].path.filename() == "skin.png");
  CHECK(text.companions[0].bytes == rich.image);
  CHECK(text.companions[1].path.filename() == "b.bin");
  // In the same folder the image is where it was.
  const Encoded beside =
      encode_scene(folder / "b.gltf", file, {file.mesh, file.attributes, file.parts.of_face, {}});
  CHECK(beside.companions.size() == 1);
  CHECK(Json::parse(beside.bytes)["images"][0]["uri"] == "skin.png");

  std::filesystem::remove(folder / "skin.png");
  const Encoded missing =
      encode_scene(folder / "b.glb", file, {file.mesh, file.attributes, file.parts.of_face, {}});
  CHECK(missing.report.lost_files == Names{"the image 'skin.png' is missing; the result names it as it was"});
}

TEST_CASE("glTF: an image outside of its folder is refused, and named from where the result is") {
  const Folder folder;
  RichScene rich;
  std::filesystem::create_directories(folder / "in/sub");
  std::filesystem::create_directories(folder / "out");
  folder.put("in/a b.png", rich.image);
  rich.built.json["images"] = {{{"uri", "../a%20b.png"}}, {{"uri", "https://a.b/c.png"}}};
  folder.put("in/sub/a.gltf", gltf_text(rich.built.json));
  const MeshFile file = read_kept_scene(folder, "in/sub/a.gltf");
  CHECK(file.report.refused == std::set<std::string>{"'../a b.png', which leads out of its folder"});
  for (const std::string name : {"out/b.gltf", "out/b.glb"}) {
    const Encoded out =
        encode_scene(folder / name, file, {file.mesh, file.attributes, file.parts.of_face, {}});
    CHECK(out.report.lost_files ==
          Names{"the image '../a b.png', which leads out of its folder, is refused; the result names it "
                "'../in/a b.png'",
                "the image 'https://a.b/c.png', a URL, is refused; the result names it as it was"});
    const Json json = name == "out/b.glb" ? json_of(out.bytes) : Json::parse(out.bytes);
    CHECK(json["images"][0]["uri"] == "../in/a%20b.png");
    CHECK(json["images"][1]["uri"] == "https://a.b/c.png");
  }
}

TEST_CASE("glTF: files outside of its folder are not read") {
  const Folder folder;
  RichScene rich;
  std::filesystem::create_directories(folder / "in");
  folder.put("secret.bin", rich.built.buffer);
  std::filesystem::create_symlink("../secret.bin", folder / "in/link.bin");
  const auto error = [&](const std::string& uri) {
    Json json = rich.built.json;
    json["buffers"][0]["uri"] = uri;
    return folder.error("in/a.gltf", json.dump());
  };
  const auto refused = [](const std::string& what) {
    return "in/a.gltf: its data are refused: " + what + "; only files in its folder are read";
  };
  CHECK(error("../secret.bin") == refused("'../secret.bin', which leads out of its folder"));
  CHECK(error("%2e%2e/secret.bin") == refused("'../secret.bin', which leads out of its folder"));
  CHECK(error("x/../../secret.bin") == refused("'x/../../secret.bin', which leads out of its folder"));
  CHECK(error("link.bin") == refused("'link.bin', which leads out of its folder"));
  CHECK_THAT(error((folder / "secret.bin").string()),
             Catch::Matchers::Contains("refused") && Catch::Matchers::Contains("an absolute path"));
  CHECK(error("https://a.b/c.bin") == refused("'https://a.b/c.bin', a URL"));
  CHECK(error("none.bin") == "in/a.gltf: its data cannot be read: 'none.bin' is missing or not a file");
}

TEST_CASE("glTF: what a buffer has that no face of the piece uses is no vertex; the file's numbers stay") {
  const Folder folder;
  Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  std::string data;
  for (const float x : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 5.0F, 5.0F,
                        5.0F, 0.0F, 0.0F, 2.0F, 1.0F, 0.0F, 2.0F, 0.0F, 1.0F, 2.0F})
    data.append(reinterpret_cast<const char*>(&x), sizeof(x));
  data += std::string("\0\1\2\4\5\6", 6);
  json["buffers"] = {{{"byteLength", data.size()}, {"uri", "a.bin"}}};
  json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 84}},
                         {{"buffer", 0}, {"byteOffset", 84}, {"byteLength", 6}}};
  json["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", 7}, {"type", "VEC3"}},
      {{"bufferView", 1}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}},
      {{"bufferView", 1}, {"byteOffset", 3}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}}};
  // Both pieces use the one vertex buffer.
  json["meshes"] = {{{"primitives",
                      {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}},
                       {{"attributes", {{"POSITION", 0}}}, {"indices", 2}}}}}};
  json["nodes"] = {{{"mesh", 0}}};
  json["scenes"] = {{{"nodes", {0}}}};
  folder.put("a.bin", data);
  folder.put("a.gltf", json.dump());
  constexpr std::uint32_t out = MeshFile::left_out;
  const MeshFile flat = read_mesh(folder / "a.gltf");
  CHECK(flat.mesh.points.size() == 6);
  CHECK(flat.mesh.triangles == Triangles{{0, 1, 2}, {3, 4, 5}});
  CHECK(flat.vertex_of ==
        std::vector<std::uint32_t>{0, 1, 2, out, out, out, out, out, out, out, out, 3, 4, 5});
  const MeshFile kept = read_kept_scene(folder, "a.gltf");
  CHECK(kept.mesh.points.size() == 6);
  const Encoded again =
      encode_scene(folder / "b.glb", kept, {kept.mesh, kept.attributes, kept.parts.of_face, {}});
  const Json written = json_of(again.bytes);
  const auto count = [&](std::size_t piece) {
    const Json& part = written["meshes"][0]["primitives"][piece];
    return written["accessors"][part["attributes"]["POSITION"].get<std::size_t>()]["count"].get<int>();
  };
  CHECK(count(0) == 3);
  CHECK(count(1) == 3);
  CHECK(again.report.doubled_vertices == 0);
}

TEST_CASE("glTF: a mesh of another format is written as .gltf with its data beside it") {
  const Folder folder;
  write_mesh(folder / "a b.gltf", square(), {}, {square_normals()});
  CHECK(json_in(folder, "a b.gltf")["buffers"][0]["uri"] == "a%20b.bin");
  const MeshFile back = read_mesh(folder / "a b.gltf");
  CHECK(same_bits<float>(back.mesh, square()));
  CHECK(same_attribute(back.attributes.at(0), square_normals(), square()));
  write_mesh(folder / "a b.gltf", square());  // its own data go
  CHECK_FALSE(std::filesystem::exists(folder / "a b.bin"));
  folder.put("c.bin", "mine");
  write_mesh(folder / "c.gltf", square());
  CHECK(folder.get("c.bin") == "mine");
  CHECK(same_bits<float>(read_mesh(folder / "c.gltf").mesh, square()));
  WriteOptions options;
  options.format = "gltf";
  CHECK(folder.message([&] { encode_mesh("-", square(), options); }) ==
        "standard output: gltf has its data in a file beside it; standard output takes glb");
}

TEST_CASE(
    "scene: views that share bytes share them in the result, and an image of several views is one file") {
  const Folder folder;
  RichScene rich;
  Json& json = rich.built.json;
  const Json png = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
  Json same_bytes = Json::array();
  json["textures"] = Json::array();
  json["images"] = Json::array();
  for (Json& material : json["materials"]) material = Json::object();
  for (std::size_t i = 0; i < 100; ++i) {
    json["bufferViews"].push_back(png);
    same_bytes.push_back(json["bufferViews"].size() - 1);
    json["images"].push_back({{"bufferView", same_bytes.back()}, {"mimeType", "image/png"}});
    json["textures"].push_back({{"source", i}});
    json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
  }
  json["extensions"] = {{"ACME_views", {{"views", same_bytes}}}};
  json["extensionsUsed"] = {"ACME_views"};
  folder.put("a.gltf", json.dump());
  const MeshFile file = read_kept_scene(folder, "a.gltf");
  const Encoded out = unchanged(folder, file, "b.glb");
  std::size_t copies = 0;
  for (std::size_t at = 0; (at = out.bytes.find(rich.image, at)) != std::string::npos; ++at) ++copies;
  CHECK(copies == 1);
  const Json views = json_of(out.bytes)["bufferViews"];
  for (const Json& view : same_bytes)
    CHECK(views[view.get<std::size_t>()]["byteOffset"] ==
          views[same_bytes[0].get<std::size_t>()]["byteOffset"]);
  const MeshFile flat = read_mesh(folder / "a.gltf");
  CHECK(flat.parts.images.size() == 1);
  CHECK(flat.parts.materials.back().image == 0);
}

TEST_CASE("scene: a node below itself, and a joint that a skin does not have, are errors") {
  const Folder folder;
  const auto error = [&](const Json& json) {
    folder.put("a.gltf", json.dump());
    return folder.message([&] { read_kept_scene(folder, "a.gltf"); });
  };
  Json json = RichScene().built.json;
  json["nodes"].push_back({{"children", {json["nodes"].size()}}});
  CHECK(error(json) == "a.gltf: its JSON is damaged: a node is below itself");
  json = RichScene().built.json;
  json["skins"][0]["joints"].erase(1);
  CHECK(error(json) == "a.gltf: a vertex follows joint 1 of a skin that has 1; --flatten leaves skins out");
}

}  // namespace whittle::files
