#include "cli/contents.hh"

#include <map>
#include <vector>

#include "files/Scene.hh"
#include "text/format.hh"
#include "text/printable.hh"

namespace whittle::cli {
namespace {

/// Each name with how many faces have it, in the order of the file. \param name_of  of a part
template <typename Name>
Json faces_by_name(const files::Parts& parts, Name name_of) {
  std::vector<std::string> names;
  std::vector<std::size_t> place;
  std::map<std::string, std::size_t> known;
  for (const files::Part& part : parts.list) {
    const auto [at, is_new] = known.emplace(name_of(part), names.size());
    if (is_new) names.push_back(at->first);
    place.push_back(at->second);
  }
  std::vector<std::size_t> faces(names.size(), 0);
  for (const std::uint32_t part : parts.of_face) ++faces[place[part]];
  Json out = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty()) out.push_back({{"name", names[i]}, {"faces", faces[i]}});
  return out;
}

/// What each of a list is called; an image without a name by its file.
Json names_in(const nlohmann::json& document, const char* key) {
  Json out = Json::array();
  if (!document.contains(key) || !document[key].is_array()) return out;
  for (const nlohmann::json& one : document[key]) {
    const auto text = [&](const char* member) {
      const bool is_there = one.is_object() && one.contains(member) && one[member].is_string();
      return is_there ? one[member].get<std::string>() : std::string();
    };
    const std::string uri = text("uri");
    out.push_back(!text("name").empty() || uri.rfind("data:", 0) == 0 ? text("name") : uri);
  }
  return out;
}

std::size_t nodes_with_mesh(const nlohmann::json& document) {
  std::size_t count = 0;
  if (document.contains("nodes"))
    for (const nlohmann::json& node : document["nodes"]) count += node.contains("mesh") ? 1 : 0;
  return count;
}

Json scene_json(const std::string& path) {
  files::ReadOptions options;
  options.keep_scene = true;
  const files::MeshFile kept = files::read_mesh(path, options);
  if (!kept.scene) return nullptr;
  const nlohmann::json& document = kept.scene->document;
  Json out = {{"vertices", kept.mesh.points.size()},
              {"faces", kept.mesh.triangles.size()},
              {"nodes_with_mesh", nodes_with_mesh(document)}};
  for (const char* key : {"nodes", "meshes", "materials", "images", "cameras", "animations", "skins"})
    out[key] = names_in(document, key);
  out["extensions"] = document.contains("extensionsUsed") ? Json(document["extensionsUsed"]) : Json::array();
  return out;
}

/// "  materials              2: red (12 faces), blue (4 faces)"; empty for an empty list.
std::string names_line(const char* what, const Json& list, const std::string& more = "") {
  constexpr std::size_t most = 12;
  if (list.empty()) return "";
  std::string out = text::format("  %-22s %zu%s", what, list.size(), more.c_str());
  for (std::size_t i = 0; i < list.size() && i < most; ++i) {
    const Json& name = list[i].is_object() ? list[i]["name"] : list[i];
    const std::string text = name.is_string() ? name.get<std::string>() : "";
    out += (i == 0 ? ": " : ", ") + (text.empty() ? "(no name)" : text::printable(text));
    if (list[i].is_object()) out += " (" + list[i]["faces"].dump() + " faces)";
  }
  return out + (list.size() > most ? ", ...\n" : "\n");
}

}  // namespace

Json materials_json(const files::Parts& parts) {
  std::vector<std::size_t> faces(parts.materials.size(), 0);
  for (const std::uint32_t part : parts.of_face)
    if (const std::uint32_t material = parts.list[part].material; material < faces.size()) ++faces[material];
  Json out = Json::array();
  for (std::size_t i = 0; i < faces.size(); ++i)
    out.push_back({{"name", parts.materials[i].name}, {"faces", faces[i]}});
  return out;
}

Json contents_json(const std::string& path, const files::MeshFile& in) {
  Json images = Json::array(), libraries = Json::array();
  for (const files::Image& image : in.parts.images) images.push_back(image.name);
  for (const files::Library& library : in.parts.libraries) libraries.push_back(library.name);
  const bool is_gltf = in.report.format.rfind("glTF", 0) == 0;
  return {{"unit", in.unit.empty() ? Json(nullptr) : Json(in.unit)},
          {"materials", materials_json(in.parts)},
          {"objects", faces_by_name(in.parts, [](const files::Part& part) { return part.object; })},
          {"groups", faces_by_name(in.parts, [](const files::Part& part) { return part.group; })},
          {"images", images},
          {"libraries", libraries},
          {"scene", is_gltf && path != "-" ? scene_json(path) : Json(nullptr)}};
}

std::string contents_text(const Json& contents) {
  std::string out;
  if (contents["unit"].is_string())
    out += text::format("  %-22s %s\n", "unit", contents["unit"].get<std::string>().c_str());
  for (const char* key : {"materials", "objects", "groups", "images", "libraries"})
    out += names_line(key, contents[key]);
  const Json& scene = contents["scene"];
  if (scene.is_null()) return out;
  out += text::format("scene, as simplify counts it, each mesh once: %zu vertices, %zu faces\n",
                      scene["vertices"].get<std::size_t>(), scene["faces"].get<std::size_t>());
  out += names_line("nodes", scene["nodes"]);
  out += names_line("meshes", scene["meshes"],
                    text::format(", shown by %zu nodes", scene["nodes_with_mesh"].get<std::size_t>()));
  for (const char* key : {"images", "cameras", "animations", "skins", "extensions"})
    out += names_line(key, scene[key]);
  return out;
}

}  // namespace whittle::cli
