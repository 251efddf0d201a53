/// \file
/// glTF documents made by hand.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "files/bytes.hh"
#include "samples.hh"

namespace whittle::files {

using Json = nlohmann::json;

inline std::string base64(const std::string& bytes) {
  const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63U];
  }
  return text;
}

/// A document under construction, with one buffer inside.
class GltfBuilder {
 public:
  Json json = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  /// \return the view of these bytes
  int view(const std::string& bytes, int stride = 0) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) view["byteStride"] = stride;
    json["bufferViews"].push_back(view);
    buffer += bytes;
    json["buffers"] = {
        {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    return static_cast<int>(json["bufferViews"].size()) - 1;
  }

  int accessor(int view, int component_type, const char* type, std::size_t count) {
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component_type}, {"type", type}, {"count", count}});
    return static_cast<int>(json["accessors"].size()) - 1;
  }

  int floats(const std::vector<float>& values, const char* type, std::size_t width) {
    std::string bytes;
    for (const float value : values) append_little(bytes, value);
    return accessor(view(bytes), 5126, type, values.size() / width);
  }
};

/// square() with its normals, in a scene of one node. Its accessors: positions, normals, indices.
inline GltfBuilder square_builder() {
  GltfBuilder built;
  std::vector<float> points;
  for (const IndexedMesh::Point& point : square().points)
    for (const double value : point) points.push_back(static_cast<float>(value));
  const int positions = built.floats(points, "VEC3", 3);
  const int normals = built.floats(square_normals().values, "VEC3", 3);
  const int indices = built.accessor(built.view(std::string("\0\1\2\0\2\3", 6)), 5121, "SCALAR", 6);
  built.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}}}}}};
  built.json["nodes"] = {{{"mesh", 0}}};
  built.json["scenes"] = {{{"nodes", {0}}}};
  built.json["scene"] = 0;
  return built;
}
inline Json gltf_square() {
  return square_builder().json;
}

inline std::string gltf_text(const Json& json) {
  return json.dump();
}

/// The binary container of a document and what stands behind it.
inline std::string glb_of(const std::string& json, const std::string& binary = "") {
  const auto chunk = [](std::string data, const char* type, char padding) {
    data.resize((data.size() + 3) / 4 * 4, padding);
    std::string bytes;
    append_little(bytes, static_cast<std::uint32_t>(data.size()));
    return bytes + std::string(type, 4) + data;
  };
  std::string chunks = chunk(json, "JSON", ' ');
  if (!binary.empty()) chunks += chunk(binary, "BIN\0", '\0');
  std::string bytes = "glTF";
  append_little(bytes, std::uint32_t{2});
  append_little(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return bytes + chunks;
}
inline std::string glb_of(const Json& json) {
  return glb_of(json.dump());
}

/// The document in a GLB file.
inline Json json_of(const std::string& glb) {
  const auto length = load<std::uint32_t>(glb.data() + 12, ByteOrder::little);
  return Json::parse(glb.substr(20, length));
}

}  // namespace whittle::files
