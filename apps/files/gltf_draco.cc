#include "files/gltf_draco.hh"

#include <tiny_gltf.h>

#include <cstdint>
#include <cstring>

#include "files/DracoDecoder.hh"
#include "files/Fault.hh"
#include "files/GltfData.hh"
#include "files/bytes.hh"
#include "files/gltf_nodes.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

[[noreturn]] void throw_wrong(const char* what) {
  throw Fault(std::string("its JSON is damaged: wrong '") + what + "' of a part packed by " + kDraco);
}

std::uint32_t number_at(const Json& object, const char* key, const char* what) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_unsigned() || found->get<std::uint64_t>() > 0x7fffffff)
    throw_wrong(what);
  return found->get<std::uint32_t>();
}

/// None where they are wrong, which others will find.
Json& primitives_of(Json& mesh) {
  static Json none = Json::array();
  const auto primitives = mesh.find("primitives");
  return primitives != mesh.end() && primitives->is_array() ? *primitives : none;
}

const Json* extension_of(const Json& part) {
  if (!part.is_object()) return nullptr;
  const auto extensions = part.find("extensions");
  if (extensions == part.end() || !extensions->is_object()) return nullptr;
  const auto draco = extensions->find(kDraco);
  return draco == extensions->end() ? nullptr : &*draco;
}

DracoPart packed_part(const Json& part, const Json& extension) {
  DracoPart out;
  if (!extension.is_object()) throw_wrong("bufferView");
  out.view = number_at(extension, "bufferView", "bufferView");
  const auto packed = extension.find("attributes"), named = part.find("attributes");
  if (packed == extension.end() || !packed->is_object() || named == part.end() || !named->is_object())
    throw_wrong("attributes");
  for (const auto& [name, number] : packed->items())
    out.attributes[name] = {number_at(*named, name.c_str(), "attributes"),
                            number_at(*packed, name.c_str(), "attributes")};
  if (out.attributes.empty()) throw_wrong("attributes");
  const Json mode = part.value("mode", Json(TINYGLTF_MODE_TRIANGLES));
  if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP) throw_wrong("mode");
  return out;
}

bool is_there_unpacked(const Json& accessors, const Json& part, const DracoPart& packed) {
  const auto has_view = [&](std::size_t accessor) {
    return accessor < accessors.size() && accessors[accessor].contains("bufferView");
  };
  bool all = !part.contains("indices") || has_view(number_at(part, "indices", "indices"));
  for (const auto& [name, values] : packed.attributes) all = all && has_view(values.accessor);
  return all;
}

/// \param type  Draco's name of T: numbers of this type come as they are, others by what they stand for
template <typename T>
void append_values(const draco::PointAttribute& from, draco::DataType type, std::uint32_t points,
                   std::string& to) {
  if (!from.is_mapping_identity() && from.indices_map_size() < points)
    throw Fault("its data are damaged: a point without a value");
  std::vector<T> value(from.num_components());
  const std::size_t width = sizeof(T) * value.size(), begin = to.size();
  to.resize(begin + width * points);
  for (std::uint32_t i = 0; i < points; ++i) {
    const draco::AttributeValueIndex at = from.mapped_index(draco::PointIndex(i));
    if (at.value() >= from.size()) throw Fault("its data are damaged: a point without a value");
    if (from.data_type() == type)
      from.GetValue(at, value.data());
    else if (!from.ConvertValue<T>(at, value.data()))
      throw Fault("its data are damaged: a value that does not fit its accessor");
    std::memcpy(to.data() + begin + i * width, value.data(), width);
  }
}

void append_typed(const draco::PointAttribute& from, int type, std::uint32_t points, std::string& to) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return append_values<std::int8_t>(from, draco::DT_INT8, points, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return append_values<std::uint8_t>(from, draco::DT_UINT8, points, to);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return append_values<std::int16_t>(from, draco::DT_INT16, points, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return append_values<std::uint16_t>(from, draco::DT_UINT16, points, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return append_values<std::uint32_t>(from, draco::DT_UINT32, points, to);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return append_values<float>(from, draco::DT_FLOAT32, points, to);
    default:
      throw Fault("an accessor of an unknown type of number");
  }
}

class Unpacking {
 public:
  Unpacking(tinygltf::Model& model, const std::vector<std::string_view>& buffers, std::size_t file_bytes)
      : model_(model), data_(model, buffers, file_bytes), buffer_(static_cast<int>(buffers.size())) {
    limits_.result_bytes = (std::size_t{16} << 20) + 128 * file_bytes;
    limits_.working_bytes = (std::size_t{64} << 20) + 512 * file_bytes;
  }

  void unpack(const DracoPart& part) {
    tinygltf::Primitive& primitive = model_.meshes.at(part.mesh).primitives.at(part.primitive);
    const std::unique_ptr<draco::Mesh> mesh = decode_draco(data_.view_bytes(part.view), limits_);
    for (const auto& [name, values] : part.attributes) {
      const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(values.number);
      if (attribute == nullptr || values.accessor >= model_.accessors.size() ||
          data_.components(static_cast<int>(values.accessor)) != attribute->num_components())
        throw_wrong("attributes");
      tinygltf::Accessor fresh = model_.accessors[values.accessor];
      fresh.sparse.isSparse = false;
      const std::size_t begin = bytes_.size();
      append_typed(*attribute, fresh.componentType, mesh->num_points(), bytes_);
      primitive.attributes[name] = add(std::move(fresh), mesh->num_points(), begin);
    }
    tinygltf::Accessor indices;
    indices.type = TINYGLTF_TYPE_SCALAR;
    indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    const std::size_t begin = bytes_.size();
    for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face)
      for (const draco::PointIndex& corner : mesh->face(face)) append_little(bytes_, corner.value());
    primitive.indices = add(std::move(indices), 3 * std::size_t{mesh->num_faces()}, begin);
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
  }

  std::string take_bytes() { return std::move(bytes_); }

 private:
  /// An accessor to what stands behind `begin`. \return its number
  int add(tinygltf::Accessor&& accessor, std::size_t count, std::size_t begin) {
    tinygltf::BufferView view;
    view.buffer = buffer_;
    view.byteOffset = begin;
    view.byteLength = bytes_.size() - begin;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    accessor.byteOffset = 0;
    accessor.count = count;
    model_.bufferViews.push_back(view);
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  tinygltf::Model& model_;
  GltfData data_;
  int buffer_;
  DracoLimits limits_;
  std::string bytes_;
};

}  // namespace

std::vector<DracoPart> take_draco_parts(Json& document) {
  std::vector<DracoPart> parts;
  const Json& accessors = gltf_objects(document, "accessors");
  std::size_t number = 0;
  for (Json& mesh : gltf_objects(document, "meshes")) {
    std::size_t primitive = 0;
    for (Json& part : primitives_of(mesh)) {
      const Json* extension = extension_of(part);
      const std::size_t at = primitive++;
      if (extension == nullptr) continue;
      DracoPart packed = packed_part(part, *extension);
      if (is_there_unpacked(accessors, part, packed)) continue;
      packed.mesh = number;
      packed.primitive = at;
      for (const auto& [name, values] : packed.attributes) part["attributes"].erase(name);
      part.erase("indices");
      parts.push_back(std::move(packed));
    }
    ++number;
  }
  erase_draco(document);
  return parts;
}

std::string unpack_draco(const std::vector<DracoPart>& parts, tinygltf::Model& model,
                         const std::vector<std::string_view>& buffers, std::size_t file_bytes) {
  if (parts.empty()) return {};
  Unpacking unpacking(model, buffers, file_bytes);
  for (const DracoPart& part : parts) unpacking.unpack(part);
  return unpacking.take_bytes();
}

void erase_draco(Json& document) {
  if (!document.contains("meshes")) return;
  for (Json& mesh : gltf_objects(document, "meshes"))
    for (Json& part : primitives_of(mesh)) {
      if (extension_of(part) == nullptr) continue;
      const auto extensions = part.find("extensions");
      extensions->erase(kDraco);
      if (extensions->empty()) part.erase(extensions);
    }
}

}  // namespace whittle::files
