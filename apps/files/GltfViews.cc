#include "files/GltfViews.hh"

#include "files/bytes.hh"
#include "files/scene_references.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kTypeOfBytes = 5121, kTypeOfShorts = 5123,
                      kTypeOfFloats = 5126;  // 5120 and 5122 are the signed ones

const Json& list_of_views(const Json& json, const char* key) {
  static const Json none = Json::array();
  return json.contains(key) ? json[key] : none;
}

std::size_t component_size(std::size_t type) {
  return type <= kTypeOfBytes ? 1 : type <= kTypeOfShorts ? 2 : 4;
}

std::size_t n_components(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

}  // namespace

bool shows_triangles(const Json& part) {
  return part.value("mode", 4) == 4;
}

GltfViews::GltfViews(Json& document, const std::string& buffer) : json_(document) {
  for (const Json& view : list_of_views(json_, "bufferViews"))
    views_.push_back(
        {buffer.substr(view.value("byteOffset", std::size_t{0}), view.at("byteLength").get<std::size_t>()),
         view.value("byteStride", std::size_t{0})});
  uses_.resize(list_of_views(json_, "accessors").size());
  std::vector<Scene::Piece> parts;
  std::size_t mesh = 0;
  for (const Json& object : list_of_views(json_, "meshes")) {
    std::size_t primitive = 0;
    for (const Json& part : object.at("primitives")) {
      parts.push_back({mesh, primitive++, {}});
      note_part(mesh, part);
    }
    ++mesh;
  }
  const SceneReferences besides = references_besides(json_, parts);
  for (std::size_t i = 0; i < uses_.size(); ++i) uses_[i].elsewhere = besides.accessors[i];
  accessors_.resize(views_.size());
  std::size_t number = 0;
  for (const Json& accessor : list_of_views(json_, "accessors")) {
    if (accessor.contains("bufferView")) accessors_.at(view_number(number)).push_back(number);
    ++number;
  }
  for (std::size_t i = 0; i < views_.size(); ++i)
    if (besides.views[i]) accessors_[i].clear();
}

void GltfViews::note_part(std::size_t mesh, const Json& part) {
  if (part.contains("indices")) {
    note_use(mesh, part["indices"], &Use::as_indices);
    if (!shows_triangles(part)) uses_.at(part["indices"].get<std::size_t>()).of_triangles = false;
  }
  for (const Json& number : part.at("attributes")) note_use(mesh, number, &Use::as_vertices);
  for (const Json& target : list_of_views(part, "targets"))
    for (const Json& number : target) note_use(mesh, number, &Use::as_vertices);
}

void GltfViews::note_use(std::size_t mesh, const Json& number, bool Use::*as) {
  Use& use = uses_.at(number.get<std::size_t>());
  if (use.times == 0) use.mesh = mesh;
  use.in_several_meshes = use.in_several_meshes || use.mesh != mesh;
  use.*as = true;
  ++use.times;
}

std::size_t GltfViews::view_number(std::size_t accessor) const {
  return json_["accessors"].at(accessor).at("bufferView").get<std::size_t>();
}

bool GltfViews::is_alone(std::size_t number) const {
  const Json& accessor = json_["accessors"].at(number);
  if (!accessor.contains("bufferView") || accessor.contains("sparse") || uses_.at(number).elsewhere ||
      accessor.value("byteOffset", std::size_t{0}) != 0)
    return false;
  const std::size_t count = accessor.at("count").get<std::size_t>();
  return accessors_of(view_number(number)).size() == 1 && count > 0 &&
         (count - 1) * stride(number) + value_bytes(number) <= view_of(number).bytes.size();
}

bool GltfViews::are_floats_alone(std::size_t number) const {
  return is_alone(number) && json_["accessors"].at(number).at("componentType") == kTypeOfFloats;
}

std::size_t GltfViews::value_bytes(std::size_t number) const {
  const Json& accessor = json_["accessors"].at(number);
  return component_size(accessor.at("componentType").get<std::size_t>()) *
         n_components(accessor.at("type").get<std::string>());
}

std::size_t GltfViews::stride(std::size_t number) const {
  const std::size_t said = views_.at(view_number(number)).stride;
  return said > 0 ? said : value_bytes(number);
}

std::vector<float> GltfViews::floats(std::size_t number) const {
  const std::string& bytes = view_of(number).bytes;
  const std::size_t count = json_["accessors"][number]["count"].get<std::size_t>();
  std::vector<float> values;
  values.reserve(count * value_bytes(number) / sizeof(float));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < value_bytes(number); k += sizeof(float))
      values.push_back(load<float>(bytes.data() + i * stride(number) + k, ByteOrder::little));
  return values;
}

std::vector<std::uint32_t> GltfViews::indices(std::size_t number) const {
  const std::string& bytes = view_of(number).bytes;
  const std::size_t count = json_["accessors"][number]["count"].get<std::size_t>(),
                    width = value_bytes(number);
  std::vector<std::uint32_t> out;
  out.reserve(count);
  for (const char* from = bytes.data(); out.size() < count; from += width)
    out.push_back(width == 1   ? load<std::uint8_t>(from, ByteOrder::little)
                  : width == 2 ? load<std::uint16_t>(from, ByteOrder::little)
                               : load<std::uint32_t>(from, ByteOrder::little));
  return out;
}

std::string GltfViews::joined() {
  std::string buffer;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    Json& view = json_["bufferViews"][i];
    view["buffer"] = 0;
    view["byteOffset"] = buffer.size();
    view["byteLength"] = views_[i].bytes.size();
    view.erase("byteStride");
    if (views_[i].stride > 0) view["byteStride"] = views_[i].stride;
    buffer += views_[i].bytes;
  }
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  if (!buffer.empty()) json_["buffers"][0]["byteLength"] = buffer.size();
  return buffer;
}

}  // namespace whittle::files
