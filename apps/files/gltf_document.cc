#include "files/gltf_document.hh"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "files/Fault.hh"
#include "files/GltfParser.hh"
#include "files/gltf_nodes.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

/// Both parsers and the code behind them call themselves for each level.
void check_depth(std::string_view json) {
  constexpr int deepest = 64;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > deepest) throw Fault("its JSON is nested too deeply");
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

struct Section {
  std::string_view key;
  const char* meaning;  ///< where it is not read; null: read, or of no interest
};

constexpr Section sections[] = {
    {"asset", nullptr},           {"scene", nullptr},    {"scenes", nullptr},
    {"nodes", nullptr},           {"meshes", nullptr},   {"accessors", nullptr},
    {"bufferViews", nullptr},     {"buffers", nullptr},  {"extensionsRequired", nullptr},
    {"materials", nullptr},       {"textures", nullptr}, {"images", nullptr},
    {"animations", "animations"}, {"skins", "skins"},    {"cameras", "cameras"},
    {"extensions", "extensions"}, {"extras", "extras"},
};

/// Lets through only what is read, so that nothing else takes memory.
class Filter {
 public:
  Filter(bool keeps_scene, MeshBuilder& builder) : keeps_scene_(keeps_scene), builder_(builder) {}

  bool operator()(int depth, const std::string& key) { return depth == 1 ? enter(key) : is_read(depth, key); }

 private:
  bool enter(const std::string& key) {
    section_ = key;
    extensions_ = 0;
    for (const Section& section : sections) {
      if (section.key != key) continue;
      if (section.meaning != nullptr && !keeps_scene_) builder_.ignore_besides(section.meaning);
      return section.meaning == nullptr;
    }
    return false;
  }

  bool is_read(int depth, const std::string& key) {
    if (section_ == "meshes" && extensions_ > 0 && depth == extensions_ + 1)
      return key == "KHR_draco_mesh_compression";
    if (depth <= extensions_) extensions_ = 0;
    if (section_ == "meshes" && key == "extensions") extensions_ = depth;
    if (section_ == "meshes" && key == "targets" && !keeps_scene_) builder_.ignore_besides("morph targets");
    if (key == "extensions") return section_ != "accessors";
    if (key == "name") return section_ == "nodes" || section_ == "materials" || section_ == "images";
    return key != "extras" && (key != "targets" || keeps_scene_) && key != "weights";
  }

  bool keeps_scene_;
  MeshBuilder& builder_;
  std::string section_;
  int extensions_ = 0;  ///< of a mesh or a part: how deep they are
};

template <typename Wanted>
Json parse(std::string_view text, Wanted wanted) {
  check_depth(text);
  GltfParser parser{std::move(wanted)};
  try {
    if (Json::sax_parse(text.begin(), text.end(), &parser)) {
      Json json = parser.take();
      if (json.is_object()) return json;
    }
  } catch (const Json::exception&) {
    // The parser's message would take more than a line.
  }
  throw Fault("its JSON is damaged");
}

void check_version(const Json& json) {
  const auto asset = json.find("asset");
  const bool known = asset != json.end() && asset->is_object() && asset->contains("version") &&
                     (*asset)["version"].is_string();
  const std::string version = known ? (*asset)["version"].get<std::string>() : "";
  if (version.rfind("2.", 0) != 0)
    throw Fault(version.empty() ? "not glTF: it does not say its version"
                                : "glTF version " + in_quotes(version) + " is not supported");
}

/// What is about looks alone changes nothing about the mesh.
bool can_do_without(const std::string& extension) {
  for (const char* beginning : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                                "EXT_lights_", "KHR_xmp", "MSFT_lod"})
    if (extension.rfind(beginning, 0) == 0) return true;
  return extension == "KHR_mesh_quantization" || extension == "EXT_meshopt_compression" ||
         extension == "KHR_draco_mesh_compression" || extension == "EXT_mesh_gpu_instancing";
}

void check_extensions(const Json& json) {
  const auto required = json.find("extensionsRequired");
  if (required == json.end()) return;
  if (!required->is_array()) throw Fault("its JSON is damaged: 'extensionsRequired' is no list");
  for (const Json& extension : *required)
    if (!extension.is_string() || !can_do_without(extension.get<std::string>()))
      throw Fault("it needs the extension " +
                  (extension.is_string() ? in_quotes(extension.get<std::string>()) : "?") +
                  ", which is not supported");
}

/// tinygltf takes the default where a number is none, or negative, as if nothing were there.
void check_numbers(const Json& value) {
  constexpr std::string_view whole[] = {"buffer",     "bufferView", "byteLength", "byteOffset",
                                        "byteStride", "count",      "mode",       "componentType"};
  if (value.is_array())
    for (const Json& one : value) check_numbers(one);
  if (!value.is_object()) return;
  for (const auto& [key, held] : value.items()) {
    const bool is_whole = std::find(std::begin(whole), std::end(whole), key) != std::end(whole);
    if (is_whole ? !held.is_number_unsigned() : key == "normalized" && !held.is_boolean())
      throw Fault("its JSON is damaged: wrong '" + key + "'");
    if (key == "attributes" || (key == "indices" && !held.is_object())) {
      for (const Json& accessor : held.is_object() ? held : Json::array({held}))
        if (!accessor.is_number_unsigned()) throw Fault("its JSON is damaged: wrong '" + key + "'");
    } else {
      check_numbers(held);
    }
  }
}

std::vector<GltfBuffer> read_buffers(Json& json) {
  std::vector<GltfBuffer> buffers;
  for (Json& object : gltf_objects(json, "buffers")) {
    GltfBuffer buffer;
    buffer.bytes = gltf_unsigned(object, "byteLength");
    const Json::json_pointer fallback("/extensions/EXT_meshopt_compression/fallback");
    buffer.is_packed = object.contains(fallback) && object[fallback] == true && !object.contains("uri");
    if (const auto uri = object.find("uri"); uri != object.end()) {
      if (!uri->is_string()) throw Fault("its JSON is damaged: a 'uri' is no text");
      buffer.has_uri = true;
      buffer.uri = std::move(uri->get_ref<std::string&>());
    }
    buffers.push_back(std::move(buffer));
  }
  return buffers;
}

}  // namespace

Json whole_gltf(std::string_view text) {
  Json json = parse(text, [](int, const std::string&) { return true; });
  for (Json& buffer : gltf_objects(json, "buffers")) {
    buffer.erase("uri");
    const auto extensions = buffer.find("extensions");
    if (extensions == buffer.end() || !extensions->is_object()) continue;
    extensions->erase("EXT_meshopt_compression");
    if (extensions->empty()) buffer.erase(extensions);
  }
  take_packed_views(json, json["buffers"].size());
  erase_draco(json);
  return json;
}

GltfDocument parse_gltf(std::string_view text, bool keeps_scene, MeshBuilder& builder) {
  Json json = parse(text, Filter(keeps_scene, builder));
  check_version(json);
  check_extensions(json);
  GltfDocument document;
  document.buffers = read_buffers(json);
  document.packed = take_packed_views(json, document.buffers.size());
  document.draco = take_draco_parts(json);
  document.instances = read_gltf_nodes(json, keeps_scene, builder);
  for (const char* key : {"materials", "textures", "images"})
    document.looks[key] = std::move(gltf_objects(json, key));

  Json reduced = {{"asset", {{"version", "2.0"}}}};
  for (const char* key : {"accessors", "bufferViews", "meshes"}) {
    Json& objects = gltf_objects(json, key);
    check_numbers(objects);
    reduced[key] = std::move(objects);
  }
  document.json = reduced.dump();
  return document;
}

}  // namespace whittle::files
