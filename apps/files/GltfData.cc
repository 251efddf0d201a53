#include "files/GltfData.hh"

#include <tiny_gltf.h>

#include <algorithm>
#include <limits>

#include "files/Fault.hh"
#include "files/bytes.hh"

namespace whittle::files {
namespace {

std::size_t component_bytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      throw Fault("an accessor of an unknown type of number");
  }
}

std::size_t components_of(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    default:
      throw Fault("an accessor that is neither numbers nor vectors");
  }
}

template <typename T>
float scaled(T value, bool normalized) {
  const float number = static_cast<float>(value);
  return normalized ? std::max(number / static_cast<float>(std::numeric_limits<T>::max()), -1.0F) : number;
}

float load_component(const char* from, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled(load<std::int8_t>(from, ByteOrder::little), normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled(load<std::uint8_t>(from, ByteOrder::little), normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled(load<std::int16_t>(from, ByteOrder::little), normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled(load<std::uint16_t>(from, ByteOrder::little), normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return scaled(load<std::uint32_t>(from, ByteOrder::little), normalized);
    default:
      return load<float>(from, ByteOrder::little);
  }
}

std::uint32_t load_index(const char* from, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<std::uint8_t>(from, ByteOrder::little);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(from, ByteOrder::little);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<std::uint32_t>(from, ByteOrder::little);
    default:
      throw Fault("indices that are not unsigned integers");
  }
}

/// What the library keeps in an int, where a number too large for it comes out negative.
std::size_t unsigned_of(long long number) {
  if (number < 0) throw Fault("an accessor reaches beyond its data");
  return static_cast<std::size_t>(number);
}

}  // namespace

const tinygltf::Accessor& GltfData::at(int accessor) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size())
    throw Fault("an accessor that is not there");
  return model_.accessors[static_cast<std::size_t>(accessor)];
}

std::size_t GltfData::count(int accessor) const {
  return at(accessor).count;
}

std::size_t GltfData::components(int accessor) const {
  return components_of(at(accessor).type);
}

bool GltfData::are_bytes(int accessor) const {
  return at(accessor).componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && at(accessor).normalized;
}

bool GltfData::are_whole(int accessor) const {
  return at(accessor).componentType != TINYGLTF_COMPONENT_TYPE_FLOAT && !at(accessor).normalized;
}

void GltfData::charge(std::size_t count, std::size_t bytes_each) {
  if (count > budget_ / bytes_each) throw Fault("the scene is too many times as large as the file");
  budget_ -= count * bytes_each;
}

void GltfData::charge_values(const tinygltf::Accessor& accessor, std::size_t bytes_each) {
  // Without a view all values are zero, and nothing but their count is in the file.
  if (accessor.bufferView < 0 && accessor.count > file_bytes_) throw Fault("values that are not in the file");
  charge(accessor.count, bytes_each);
}

std::string_view GltfData::view_bytes(std::size_t view) const {
  return view_data(static_cast<long long>(std::min(view, model_.bufferViews.size())));
}

std::string_view GltfData::view_data(long long view) const {
  if (static_cast<std::size_t>(view) >= model_.bufferViews.size()) throw Fault("a view that is not there");
  const tinygltf::BufferView& bytes = model_.bufferViews[static_cast<std::size_t>(view)];
  if (bytes.buffer < 0 || static_cast<std::size_t>(bytes.buffer) >= buffers_.size())
    throw Fault("a buffer that is not there");
  const std::string_view buffer = buffers_[static_cast<std::size_t>(bytes.buffer)];
  if (bytes.byteOffset > buffer.size() || bytes.byteLength > buffer.size() - bytes.byteOffset)
    throw Fault("the file is cut off: a view reaches beyond its buffer");
  return buffer.substr(bytes.byteOffset, bytes.byteLength);
}

GltfData::Run GltfData::run(long long view, std::size_t offset, std::size_t count,
                            std::size_t value_bytes) const {
  if (view < 0) return {};
  const std::string_view data = view_data(view);
  const tinygltf::BufferView& bytes = model_.bufferViews[static_cast<std::size_t>(view)];
  const std::size_t stride = bytes.byteStride == 0 ? value_bytes : bytes.byteStride;
  if (stride < value_bytes) throw Fault("values that lie closer than they are long");
  // The last value need not be followed by its gap.
  const bool fits = count == 0 || (offset <= data.size() && data.size() - offset >= value_bytes &&
                                   (count - 1) <= (data.size() - offset - value_bytes) / stride);
  if (!fits) throw Fault("an accessor reaches beyond its data");
  return {data.data() + (count == 0 ? 0 : offset), stride};
}

std::vector<float> GltfData::floats(int index) {
  const tinygltf::Accessor& accessor = at(index);
  const std::size_t width = components_of(accessor.type);
  const std::size_t bytes = component_bytes(accessor.componentType);
  charge_values(accessor, width * sizeof(float));
  const Run values = run(accessor.bufferView, accessor.byteOffset, accessor.count, width * bytes);
  std::vector<float> result(accessor.count * width, 0.0F);
  for (std::size_t i = 0; values.begin != nullptr && i < accessor.count; ++i)
    for (std::size_t k = 0; k < width; ++k)
      result[i * width + k] = load_component(values.begin + i * values.stride + k * bytes,
                                             accessor.componentType, accessor.normalized);
  if (accessor.sparse.isSparse) replace_sparse(accessor, result);
  return result;
}

void GltfData::replace_sparse(const tinygltf::Accessor& accessor, std::vector<float>& values) {
  const auto& sparse = accessor.sparse;
  const std::size_t count = unsigned_of(sparse.count);
  const std::size_t width = components_of(accessor.type);
  const std::size_t bytes = component_bytes(accessor.componentType);
  const std::size_t index_bytes = component_bytes(sparse.indices.componentType);
  const Run indices =
      run(unsigned_of(sparse.indices.bufferView), unsigned_of(sparse.indices.byteOffset), count, index_bytes);
  const Run replaced =
      run(unsigned_of(sparse.values.bufferView), unsigned_of(sparse.values.byteOffset), count, width * bytes);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t index = load_index(indices.begin + i * indices.stride, sparse.indices.componentType);
    if (index >= accessor.count) throw Fault("a sparse accessor replaces what is not there");
    for (std::size_t k = 0; k < width; ++k)
      values[index * width + k] = load_component(replaced.begin + i * replaced.stride + k * bytes,
                                                 accessor.componentType, accessor.normalized);
  }
}

std::vector<std::uint32_t> GltfData::indices(int index) {
  const tinygltf::Accessor& accessor = at(index);
  if (accessor.type != TINYGLTF_TYPE_SCALAR || accessor.sparse.isSparse)
    throw Fault("indices that are not plain numbers");
  const std::size_t bytes = component_bytes(accessor.componentType);
  charge_values(accessor, sizeof(std::uint32_t));
  const Run values = run(accessor.bufferView, accessor.byteOffset, accessor.count, bytes);
  std::vector<std::uint32_t> result(accessor.count, 0);
  for (std::size_t i = 0; values.begin != nullptr && i < accessor.count; ++i)
    result[i] = load_index(values.begin + i * values.stride, accessor.componentType);
  return result;
}

}  // namespace whittle::files
