#include "files/gltf_materials.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/gltf_uri.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

/// The member of an object; null where there is none, or this is no object.
const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

std::optional<std::size_t> index_of(const Json& number, std::size_t count) {
  if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= count) return std::nullopt;
  return number.get<std::size_t>();
}

/// So many numbers; what is given where there are none.
template <std::size_t n>
std::array<double, n> numbers(const Json& list, std::array<double, n> otherwise) {
  if (!list.is_array() || list.size() != n) return otherwise;
  for (std::size_t i = 0; i < n; ++i)
    if (list[i].is_number()) otherwise[i] = list[i].get<double>();
  return otherwise;
}

std::string text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

const Json& base_texture(const Json& material) {
  return member(member(material, "pbrMetallicRoughness"), "baseColorTexture");
}

TextureUse use_of(const Json& texture) {
  TextureUse use;
  const Json& transform = member(member(texture, "extensions"), "KHR_texture_transform");
  const Json& set = transform.contains("texCoord") ? transform["texCoord"] : member(texture, "texCoord");
  if (set.is_number_unsigned()) use.set = set.get<std::size_t>();
  if (!transform.is_object()) return use;
  const auto offset = numbers<2>(member(transform, "offset"), {0, 0});
  const auto scale = numbers<2>(member(transform, "scale"), {1, 1});
  const Json& rotation = member(transform, "rotation");
  const double angle = rotation.is_number() ? rotation.get<double>() : 0;
  const double c = std::cos(angle), s = std::sin(angle);
  use.transform << scale[0] * c, scale[1] * s, offset[0], -scale[0] * s, scale[1] * c, offset[1];
  return use;
}

class Reader {
 public:
  Reader(const Json& looks, GltfData& data, const std::filesystem::path& path, MeshFile& file)
      : looks_(looks), data_(data), path_(path), file_(file) {}

  Material material(const Json& json) {
    Material out;
    out.name = text(member(json, "name"));
    out.colour = numbers<4>(member(member(json, "pbrMetallicRoughness"), "baseColorFactor"), out.colour);
    for (double& component : out.colour) component = std::clamp(component, 0.0, 1.0);
    const std::string alpha = text(member(json, "alphaMode"));
    if (alpha == "BLEND") out.alpha = Material::Alpha::blend;
    if (alpha == "MASK") out.alpha = Material::Alpha::mask;
    if (const Json& cutoff = member(json, "alphaCutoff"); cutoff.is_number())
      out.cutoff = cutoff.get<double>();
    const Json &textures = looks_["textures"], &images = looks_["images"];
    const auto texture = index_of(member(base_texture(json), "index"), textures.size());
    const auto image = texture ? index_of(member(textures[*texture], "source"), images.size()) : std::nullopt;
    if (image) out.image = add_image(*image, images[*image]);
    return out;
  }

 private:
  std::optional<std::size_t> add_image(std::size_t number, const Json& json) {
    const auto [place, is_new] = known_.emplace(number, std::nullopt);
    if (!is_new) return place->second;
    Image image;
    image.name = text(member(json, "name"));
    const Json& view = member(json, "bufferView");
    const std::string uri = text(member(json, "uri"));
    if (view.is_number_unsigned()) {
      const std::string_view bytes = data_.view_bytes(view.get<std::size_t>());
      const auto [same, is_first] =
          by_bytes_.emplace(std::make_pair(bytes.data(), bytes.size()), file_.parts.images.size());
      if (!is_first) return place->second = same->second;
      data_.charge(bytes.size(), 1);  // views may overlap
      image.bytes = bytes;
    } else if (is_data_uri(uri)) {
      image.bytes = decode_data_uri(uri);
    } else {
      image.name = decode_percents(uri);
      const Link link = follow_beside(path_, image.name);
      if (link.is_there) image.path = link.path;
      if (!link.refusal.empty()) {
        file_.report.refused.insert(link.refusal);
        return std::nullopt;
      }
    }
    if (image.bytes.empty() && image.path.empty()) {
      if (!image.name.empty()) file_.report.not_found.insert(image.name);
      return std::nullopt;
    }
    file_.parts.images.push_back(std::move(image));
    return place->second = file_.parts.images.size() - 1;
  }

  const Json& looks_;
  GltfData& data_;
  const std::filesystem::path& path_;
  MeshFile& file_;
  std::map<std::size_t, std::optional<std::size_t>> known_;
  std::map<std::pair<const char*, std::size_t>, std::size_t> by_bytes_;  ///< numbers of images
};

}  // namespace

std::vector<TextureUse> texture_uses(const Json& looks) {
  std::vector<TextureUse> uses;
  for (const Json& material : looks["materials"]) uses.push_back(use_of(base_texture(material)));
  return uses;
}

void read_gltf_materials(const Json& looks, GltfData& data, const std::filesystem::path& path, MeshFile& file,
                         const std::vector<TextureUse>& uses) {
  Reader reader(looks, data, path, file);
  for (const Json& material : looks["materials"]) file.parts.materials.push_back(reader.material(material));
  for (std::size_t i = 0; i < uses.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      file.parts.materials[i].texture_scale[k] = uses[i].transform.col(static_cast<int>(k)).norm();
}

}  // namespace whittle::files
