#include "files/scene_remains.hh"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace whittle::files {
namespace {

using Json = nlohmann::json;

void erase_sections(Json& document, std::initializer_list<const char*> keys) {
  for (const char* key : keys) document.erase(key);
}

void remove_textures(Json& value) {
  if (value.is_object())
    for (auto member = value.begin(); member != value.end();) {
      const std::string& key = member.key();
      const bool is_texture = key.size() >= 7 && key.compare(key.size() - 7, 7, "Texture") == 0;
      member = is_texture ? value.erase(member) : std::next(member);
    }
  if (value.is_structured())
    for (Json& one : value) remove_textures(one);
}

bool is_texture_set(const Scene::Channel& channel) {
  return channel.name.rfind("TEXCOORD_", 0) == 0;
}

bool has_positions(const Json& part) {
  return part.contains("attributes") && part["attributes"].contains("POSITION");
}

/// \return for each mesh its new number
std::vector<std::optional<std::size_t>> keep_meshes_with_parts(Json& document) {
  Json left = Json::array();
  std::vector<std::optional<std::size_t>> number;
  for (Json& mesh : document["meshes"]) {
    Json parts = Json::array();
    for (Json& part : mesh["primitives"])
      if (has_positions(part)) parts.push_back(std::move(part));
    const bool stays = !parts.empty();
    number.push_back(stays ? std::optional(left.size()) : std::nullopt);
    if (!stays) continue;
    mesh["primitives"] = std::move(parts);
    left.push_back(std::move(mesh));
  }
  document["meshes"] = std::move(left);
  if (document["meshes"].empty()) document.erase("meshes");
  return number;
}

}  // namespace

void drop_lost_looks(Json& document, const Scene& scene, bool has_materials,
                     const attributes::Attributes& attributes) {
  bool had_materials = false, had_texture = false;
  for (const Scene::Piece& piece : scene.pieces) {
    const Json& part = document["meshes"][piece.mesh]["primitives"][piece.primitive];
    had_materials = had_materials || part.contains("material");
    had_texture = had_texture || std::any_of(piece.channels.begin(), piece.channels.end(), is_texture_set);
  }
  const bool has_texture = std::any_of(attributes.begin(), attributes.end(), [](const auto& attribute) {
    return attribute.kind == attributes::Kind::texture;
  });
  if (had_materials && !has_materials) {
    for (Json& mesh : document["meshes"])
      for (Json& part : mesh["primitives"]) part.erase("material");
    erase_sections(document, {"materials", "textures", "images", "samplers"});
  } else if (had_texture && !has_texture && document.contains("materials")) {
    remove_textures(document["materials"]);
    erase_sections(document, {"textures", "images", "samplers"});
  }
}

void drop_empty_meshes(Json& document) {
  if (!document.contains("meshes")) return;
  const std::vector<std::optional<std::size_t>> number = keep_meshes_with_parts(document);
  if (!document.contains("nodes")) return;
  for (Json& node : document["nodes"]) {
    if (!node.contains("mesh")) continue;
    if (const auto now = number[node["mesh"].get<std::size_t>()]) {
      node["mesh"] = *now;
      continue;
    }
    for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
    if (node.contains("extensions")) node["extensions"].erase("EXT_mesh_gpu_instancing");
  }
}

void drop_packing_extensions(Json& document, bool are_all_new) {
  std::set<std::string> gone = {"EXT_meshopt_compression", "KHR_draco_mesh_compression"};
  if (are_all_new) gone.insert("KHR_mesh_quantization");
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    if (!document.contains(key)) continue;
    Json left = Json::array();
    for (const Json& name : document[key])
      if (!name.is_string() || gone.count(name.get<std::string>()) == 0) left.push_back(name);
    document[key] = std::move(left);
    if (document[key].empty()) document.erase(key);
  }
}

}  // namespace whittle::files
