#include "files/GltfOutput.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/bytes.hh"
#include "files/gltf_uri.hh"

namespace whittle::files {
namespace {

constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

const char* type_of(std::size_t components) {
  constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return types[components - 1];
}

std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void pad_to_four(std::string& bytes, char with) {
  bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

}  // namespace

void GltfOutput::set_free(std::vector<std::size_t> accessors, std::vector<std::size_t> views) {
  free_accessors_.assign(accessors.rbegin(), accessors.rend());
  free_views_.assign(views.rbegin(), views.rend());
}

std::size_t GltfOutput::put(const char* list, std::vector<std::size_t>& free, Json object) {
  if (!free.empty()) {
    const std::size_t number = free.back();
    free.pop_back();
    json_[list][number] = std::move(object);
    return number;
  }
  json_[list].push_back(std::move(object));
  return json_[list].size() - 1;
}

std::size_t GltfOutput::add_view(std::string_view bytes, Target target, std::size_t stride) {
  pad_to_four(buffer_, '\0');
  Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != Target::none) view["target"] = static_cast<int>(target);
  if (stride > 0) view["byteStride"] = stride;
  buffer_ += bytes;
  return put("bufferViews", free_views_, std::move(view));
}

std::size_t GltfOutput::add_accessor(std::size_t view, int component_type, std::size_t components,
                                     std::size_t count) {
  return put("accessors", free_accessors_,
             {{"bufferView", view},
              {"componentType", component_type},
              {"type", type_of(components)},
              {"count", count}});
}

std::size_t GltfOutput::add_floats(const std::vector<float>& values, std::size_t components, bool bounds) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const float value : values) append_little(bytes, value);
  const std::size_t count = values.size() / components;
  const std::size_t number = add_accessor(add_view(bytes, Target::vertices), kFloat, components, count);
  for (std::size_t k = 0; k < components && bounds && count > 0; ++k) {
    float least = values[k], most = values[k];
    for (std::size_t i = k; i < values.size(); i += components) {
      least = std::min(least, values[i]);
      most = std::max(most, values[i]);
    }
    json_["accessors"][number]["min"].push_back(static_cast<double>(least));
    json_["accessors"][number]["max"].push_back(static_cast<double>(most));
  }
  return number;
}

std::size_t GltfOutput::add_normals(std::vector<float> values) {
  constexpr float tolerance = 1e-3F;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    const float length = std::hypot(values[i], values[i + 1], values[i + 2]);
    if (length == 0 || std::abs(length - 1) < tolerance) continue;
    for (std::size_t k = 0; k < 3; ++k) values[i + k] /= length;
  }
  return add_floats(values, 3);
}

std::size_t GltfOutput::add_joints(const std::vector<float>& values) {
  const bool are_small = std::all_of(values.begin(), values.end(), [](float value) { return value <= 255; });
  std::string bytes;
  for (const float value : values) {
    if (are_small)
      append_little(bytes, static_cast<std::uint8_t>(value));
    else
      append_little(bytes, static_cast<std::uint16_t>(value));
  }
  return add_accessor(add_view(bytes, Target::vertices), are_small ? kUnsignedByte : kUnsignedShort, 4,
                      values.size() / 4);
}

std::size_t GltfOutput::add_bytes(const std::vector<float>& values, std::size_t components) {
  std::string bytes;  // three of them need a gap: each value begins at a multiple of four
  for (std::size_t i = 0; i < values.size(); ++i) {
    bytes += static_cast<char>(to_byte(values[i]));
    if (components == 3 && i % 3 == 2) bytes += '\0';
  }
  const std::size_t number = add_accessor(add_view(bytes, Target::vertices, 4), kUnsignedByte, components,
                                          values.size() / components);
  json_["accessors"][number]["normalized"] = true;
  return number;
}

std::size_t GltfOutput::add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  const bool fits_short = vertices <= std::numeric_limits<std::uint16_t>::max();
  std::string bytes;
  for (const std::uint32_t index : indices) {
    if (fits_short)
      append_little(bytes, static_cast<std::uint16_t>(index));
    else
      append_little(bytes, index);
  }
  return add_accessor(add_view(bytes, Target::indices), fits_short ? kUnsignedShort : kUnsignedInt, 1,
                      indices.size());
}

/// Numbers that are still free: those at the end go, the others name a little of nothing.
std::string& GltfOutput::finish() {
  if (std::exchange(is_finished_, true)) return buffer_;
  const auto drop_last = [](Json& list, std::vector<std::size_t>& free) {
    std::sort(free.begin(), free.end());
    while (!free.empty() && free.back() + 1 == list.size()) {
      list.erase(free.back());
      free.pop_back();
    }
  };
  if (json_.contains("accessors")) drop_last(json_["accessors"], free_accessors_);
  for (const std::size_t number : free_accessors_)
    json_["accessors"][number] = {{"componentType", kFloat}, {"type", "SCALAR"}, {"count", 1}};
  if (json_.contains("bufferViews")) drop_last(json_["bufferViews"], free_views_);
  if (!free_views_.empty()) pad_to_four(buffer_, '\0');
  for (const std::size_t number : free_views_)
    json_["bufferViews"][number] = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", 4}};
  if (!free_views_.empty()) buffer_.append(4, '\0');
  for (const char* list : {"accessors", "bufferViews"})
    if (json_.contains(list) && json_[list].empty()) json_.erase(list);
  pad_to_four(buffer_, '\0');
  if (buffer_.empty())
    json_.erase("buffers");
  else if (json_.contains("buffers") && !json_["buffers"].empty())
    json_["buffers"] = Json::array({json_["buffers"][0]});
  else
    json_["buffers"] = Json::array({Json::object()});
  if (!buffer_.empty()) json_["buffers"][0]["byteLength"] = buffer_.size();
  return buffer_;
}

std::string GltfOutput::glb() {
  finish();
  std::string json = dumped(json_);
  pad_to_four(json, ' ');
  const std::size_t length = 12 + 8 + json.size() + (buffer_.empty() ? 0 : 8 + buffer_.size());
  if (length > std::numeric_limits<std::uint32_t>::max())
    throw Fault("not written: GLB cannot hold more than 4 GiB");
  std::string bytes = "glTF";
  bytes.reserve(length);
  append_little(bytes, std::uint32_t{2});
  append_little(bytes, static_cast<std::uint32_t>(length));
  append_little(bytes, static_cast<std::uint32_t>(json.size()));
  (bytes += "JSON") += json;
  if (buffer_.empty()) return bytes;
  append_little(bytes, static_cast<std::uint32_t>(buffer_.size()));
  bytes.append("BIN\0", 4) += buffer_;
  return bytes;
}

std::string GltfOutput::gltf(const std::string& uri, std::string& data) {
  finish();
  if (!buffer_.empty()) json_["buffers"][0]["uri"] = encode_percents(uri);
  data = std::move(buffer_);
  return json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace whittle::files
