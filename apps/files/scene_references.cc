#include "files/scene_references.hh"

#include <set>
#include <string>
#include <utility>

namespace whittle::files {
namespace {

using Json = nlohmann::json;

/// Extensions that name materials, textures, nodes and the like, but no data of their own.
bool names_no_data(const std::string& extension) {
  for (const char* beginning : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
                                "KHR_lights_", "KHR_xmp", "KHR_animation_pointer", "KHR_node_", "MSFT_lod",
                                "EXT_meshopt_compression", "KHR_mesh_quantization", "VRM"})
    if (extension.rfind(beginning, 0) == 0) return true;
  return false;
}

class Search {
 public:
  Search(const Json& document, const std::vector<Scene::Piece>& pieces) : document_(document) {
    for (const Scene::Piece& piece : pieces) replaced_.emplace(piece.mesh, piece.primitive);
    found_.accessors.resize(size_of("accessors"));
    found_.views.resize(size_of("bufferViews"));
  }

  SceneReferences run() {
    for (const Json& animation : list("animations"))
      for (const Json& sampler : list_in(animation, "samplers")) {
        mark(sampler, "input", found_.accessors);
        mark(sampler, "output", found_.accessors);
      }
    for (const Json& skin : list("skins")) mark(skin, "inverseBindMatrices", found_.accessors);
    for (const Json& image : list("images")) mark(image, "bufferView", found_.views);
    std::size_t mesh = 0;
    for (const Json& object : list("meshes")) {
      std::size_t primitive = 0;
      for (const Json& part : list_in(object, "primitives"))
        if (replaced_.count({mesh, primitive++}) == 0) mark_primitive(part);
      ++mesh;
    }
    for (const auto& [key, value] : document_.items())
      if (key != "accessors" && key != "bufferViews" && key != "buffers") look_for_extensions(value);
    if (document_.contains("extensions")) mark_extensions(document_["extensions"]);
    mark_views();
    return std::move(found_);
  }

 private:
  static const Json& nothing() {
    static const Json empty = Json::array();
    return empty;
  }
  static const Json& list_in(const Json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    return found != object.end() && found->is_array() ? *found : nothing();
  }
  const Json& list(const char* key) const { return list_in(document_, key); }
  std::size_t size_of(const char* key) const { return list(key).size(); }

  static void mark_number(const Json& number, std::vector<bool>& found) {
    if (number.is_number_unsigned() && number.get<std::uint64_t>() < found.size())
      found[number.get<std::size_t>()] = true;
  }
  static void mark(const Json& object, const char* key, std::vector<bool>& found) {
    if (object.is_object() && object.contains(key)) mark_number(object[key], found);
  }

  void mark_primitive(const Json& part) {
    mark(part, "indices", found_.accessors);
    if (part.is_object() && part.contains("attributes"))
      for (const Json& accessor : part["attributes"]) mark_number(accessor, found_.accessors);
    for (const Json& target : list_in(part, "targets"))
      for (const Json& accessor : target) mark_number(accessor, found_.accessors);
  }

  void look_for_extensions(const Json& value) {
    if (value.is_object() && value.contains("extensions")) mark_extensions(value["extensions"]);
    if (value.is_structured())
      for (const Json& one : value) look_for_extensions(one);
  }

  void mark_extensions(const Json& extensions) {
    if (!extensions.is_object()) return;
    for (const auto& [name, value] : extensions.items())
      if (!names_no_data(name)) mark_all_numbers(value);
  }

  void mark_all_numbers(const Json& value) {
    mark_number(value, found_.accessors);
    mark_number(value, found_.views);
    if (value.is_structured())
      for (const Json& one : value) mark_all_numbers(one);
  }

  /// Of the accessors that are needed.
  void mark_views() {
    std::size_t number = 0;
    for (const Json& accessor : list("accessors")) {
      if (!found_.accessors[number++]) continue;
      mark(accessor, "bufferView", found_.views);
      if (!accessor.is_object() || !accessor.contains("sparse") || !accessor["sparse"].is_object()) continue;
      for (const char* part : {"indices", "values"})
        if (accessor["sparse"].contains(part)) mark(accessor["sparse"][part], "bufferView", found_.views);
    }
  }

  const Json& document_;
  std::set<std::pair<std::size_t, std::size_t>> replaced_;
  SceneReferences found_;
};

}  // namespace

SceneReferences references_besides(const Json& document, const std::vector<Scene::Piece>& pieces) {
  return Search(document, pieces).run();
}

}  // namespace whittle::files
