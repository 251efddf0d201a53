#include "files/gltf_meshopt.hh"

#include <meshoptimizer.h>

#include "files/Fault.hh"
#include "files/gltf_nodes.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

constexpr const char* kMeshopt = "EXT_meshopt_compression";

[[noreturn]] void throw_damaged_view() {
  throw Fault(std::string("its data are damaged: a view packed by ") + kMeshopt);
}

std::string word_of(const Json& object, const char* key, const char* otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_string()) throw_damaged_view();
  return found->get<std::string>();
}

PackedView packed_view(const Json& extension) {
  if (!extension.is_object()) throw_damaged_view();
  PackedView view;
  view.buffer = gltf_unsigned(extension, "buffer");
  view.offset = extension.contains("byteOffset") ? gltf_unsigned(extension, "byteOffset") : 0;
  view.length = gltf_unsigned(extension, "byteLength");
  view.stride = gltf_unsigned(extension, "byteStride");
  view.count = gltf_unsigned(extension, "count");
  view.mode = word_of(extension, "mode", "");
  view.filter = word_of(extension, "filter", "NONE");
  // The library takes for granted what is checked here.
  const bool are_values = view.mode == "ATTRIBUTES" && view.stride % 4 == 0 && view.stride <= 256;
  const bool are_indices = ((view.mode == "TRIANGLES" && view.count % 3 == 0) || view.mode == "INDICES") &&
                           (view.stride == 2 || view.stride == 4) && view.filter == "NONE";
  const bool is_filtered = view.filter == "NONE" || view.filter == "EXPONENTIAL" ||
                           (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
                           (view.filter == "QUATERNION" && view.stride == 8);
  if (view.stride == 0 || !(are_values || are_indices) || !is_filtered) throw_damaged_view();
  return view;
}

void unpack(const PackedView& view, std::string_view packed, char* to) {
  const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
  const int error = view.mode == "ATTRIBUTES"
                        ? meshopt_decodeVertexBuffer(to, view.count, view.stride, from, packed.size())
                    : view.mode == "TRIANGLES"
                        ? meshopt_decodeIndexBuffer(to, view.count, view.stride, from, packed.size())
                        : meshopt_decodeIndexSequence(to, view.count, view.stride, from, packed.size());
  if (error != 0) throw_damaged_view();
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(to, view.count, view.stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(to, view.count, view.stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(to, view.count, view.stride);
}

}  // namespace

std::vector<PackedView> take_packed_views(Json& document, std::size_t buffer) {
  std::vector<PackedView> views;
  std::size_t end = 0;
  for (Json& json : gltf_objects(document, "bufferViews")) {
    const auto extensions = json.find("extensions");
    if (extensions == json.end() || !extensions->is_object() || !extensions->contains(kMeshopt)) continue;
    PackedView view = packed_view((*extensions)[kMeshopt]);
    constexpr std::size_t most = std::size_t{1} << 40;  // so that nothing overflows; unpacked() knows better
    if (view.count > most / view.stride || end > most) throw_damaged_view();
    view.begin = end;
    json["buffer"] = buffer;
    json["byteOffset"] = end;
    json["byteLength"] = view.count * view.stride;
    extensions->erase(kMeshopt);
    if (extensions->empty()) json.erase(extensions);
    end += (view.count * view.stride + 7) / 8 * 8;
    views.push_back(std::move(view));
  }
  return views;
}

std::string unpacked(const std::vector<PackedView>& views, const std::vector<std::string_view>& buffers,
                     std::size_t most) {
  std::string bytes;
  if (views.empty()) return bytes;
  const std::size_t end = views.back().begin + views.back().count * views.back().stride;
  if (end > most) throw Fault("the scene is too many times as large as the file");
  bytes.resize(end);
  for (const PackedView& view : views) {
    if (view.buffer >= buffers.size() || view.offset > buffers[view.buffer].size() ||
        view.length > buffers[view.buffer].size() - view.offset)
      throw Fault("the file is cut off: a view reaches beyond its buffer");
    unpack(view, buffers[view.buffer].substr(view.offset, view.length), bytes.data() + view.begin);
  }
  return bytes;
}

}  // namespace whittle::files
