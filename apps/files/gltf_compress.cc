#include <meshoptimizer.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "files/Fault.hh"
#include "files/bytes.hh"
#include "files/gltf_extensions.hh"
#include "files/gltf_pack.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

constexpr const char* kCompression = "EXT_meshopt_compression";
constexpr std::uint32_t kUnnumbered = static_cast<std::uint32_t>(-1);

/// The accessors of a part's vertices; none where one of them cannot be changed for this part alone.
std::vector<std::size_t> own_vertices(const GltfViews& views, const Json& part) {
  std::vector<std::size_t> numbers;
  const auto take = [&](const Json& named) {
    for (const Json& number : named) numbers.push_back(number.get<std::size_t>());
  };
  take(part.at("attributes"));
  if (part.contains("targets"))
    for (const Json& target : part["targets"]) take(target);
  const bool are_own = std::all_of(numbers.begin(), numbers.end(), [&](std::size_t number) {
    return views.is_alone(number) && views.use(number).times == 1;
  });
  return are_own ? numbers : std::vector<std::size_t>();
}

/// For each vertex its new number: in the order in which the triangles use them, then those of none.
std::vector<std::uint32_t> numbers_by_use(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  std::vector<std::uint32_t> number(vertices);
  auto next = static_cast<std::uint32_t>(
      meshopt_optimizeVertexFetchRemap(number.data(), indices.data(), indices.size(), vertices));
  for (std::uint32_t& one : number)
    if (one == kUnnumbered) one = next++;
  return number;
}

void permute(GltfViews& views, std::size_t accessor, const std::vector<std::uint32_t>& number) {
  std::string& bytes = views.view_of(accessor).bytes;
  const std::size_t stride = views.stride(accessor);
  bytes.resize(number.size() * stride, '\0');
  std::string moved(bytes.size(), '\0');
  for (std::size_t i = 0; i < number.size(); ++i) bytes.copy(&moved[number[i] * stride], stride, i * stride);
  bytes = std::move(moved);
}

void write_indices(GltfViews& views, std::size_t accessor, const std::vector<std::uint32_t>& indices) {
  const std::size_t width = views.value_bytes(accessor);
  std::string bytes;
  for (const std::uint32_t index : indices)
    for (std::size_t k = 0; k < width; ++k) bytes += static_cast<char>(index >> (8 * k) & 0xff);
  views.view_of(accessor).bytes = std::move(bytes);
}

/// \return for each vertex its new number; nothing: they stay as they are
std::optional<std::vector<std::uint32_t>> reorder_part(GltfViews& views, const Json& part) {
  if (!part.contains("indices")) return {};
  const auto accessor = part["indices"].get<std::size_t>();
  const std::vector<std::size_t> own = own_vertices(views, part);
  if (own.empty() || !views.is_alone(accessor) || views.use(accessor).times != 1 ||
      views.stride(accessor) != views.value_bytes(accessor))
    return {};
  const auto vertices = views.accessor(own[0]).at("count").get<std::size_t>();
  std::vector<std::uint32_t> indices = views.indices(accessor);
  const auto is_wrong = [&](std::uint32_t index) { return index >= vertices; };
  if (indices.empty() || indices.size() % 3 != 0 || std::any_of(indices.begin(), indices.end(), is_wrong))
    return {};
  meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(), vertices);
  std::vector<std::uint32_t> number = numbers_by_use(indices, vertices);
  for (const std::size_t one : own) permute(views, one, number);
  for (std::uint32_t& index : indices) index = number[index];
  write_indices(views, accessor, indices);
  return number;
}

/// How the values of a view are packed.
struct Packing {
  const char* mode = nullptr;  ///< null: as it is
  std::size_t stride = 0;
};

Packing packing_of(GltfViews& views, std::size_t view) {
  const std::vector<std::size_t>& accessors = views.accessors_of(view);
  bool vertices = !accessors.empty(), indices = vertices;
  for (const std::size_t accessor : accessors) {
    const GltfViews::Use& use = views.use(accessor);
    vertices = vertices && use.as_vertices && !use.as_indices;
    indices = indices && use.as_indices && !use.as_vertices;
  }
  if (!vertices && !indices) return {};
  const std::size_t stride = views.stride(accessors[0]), size = views.views()[view].bytes.size();
  if (size == 0 || size % stride != 0) return {};
  if (vertices) return stride % 4 == 0 && stride <= 256 ? Packing{"ATTRIBUTES", stride} : Packing();
  if (stride != 2 && stride != 4) return {};
  const bool triangles =
      accessors.size() == 1 && size / stride % 3 == 0 && views.use(accessors[0]).of_triangles;
  return {triangles ? "TRIANGLES" : "INDICES", stride};
}

std::string packed(const std::string& bytes, const Packing& packing) {
  const std::size_t count = bytes.size() / packing.stride;
  const auto shrunk = [](std::string out, std::size_t size) {
    if (size == 0) throw Fault("not written: meshoptimizer cannot pack it");
    out.resize(size);
    return out;
  };
  if (packing.mode[0] == 'A') {
    std::string out(meshopt_encodeVertexBufferBound(count, packing.stride), '\0');
    const std::size_t size = meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()),
                                                        out.size(), bytes.data(), count, packing.stride);
    return shrunk(std::move(out), size);
  }
  std::vector<std::uint32_t> indices;
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const char* from = bytes.data() + i * packing.stride;
    indices.push_back(packing.stride == 2 ? load<std::uint16_t>(from, ByteOrder::little)
                                          : load<std::uint32_t>(from, ByteOrder::little));
    largest = std::max(largest, indices.back());
  }
  const bool triangles = packing.mode[0] == 'T';
  std::string out(triangles ? meshopt_encodeIndexBufferBound(count, std::size_t{largest} + 1)
                            : meshopt_encodeIndexSequenceBound(count, std::size_t{largest} + 1),
                  '\0');
  auto* to = reinterpret_cast<unsigned char*>(out.data());
  const std::size_t size = triangles
                               ? meshopt_encodeIndexBuffer(to, out.size(), indices.data(), indices.size())
                               : meshopt_encodeIndexSequence(to, out.size(), indices.data(), indices.size());
  return shrunk(std::move(out), size);
}

}  // namespace

void pack_gltf(GltfOutput& output, const WriteOptions& options, bool is_own, WriteReport& report) {
  if (options.quantize == 0 && !options.meshopt) return;
  std::string& buffer = output.finish();
  if (buffer.empty()) return;
  GltfViews views(output.json(), buffer);
  if (options.quantize > 0) quantize_gltf(views, options.quantize, is_own, report);
  if (options.meshopt) reorder_gltf(views, report);
  buffer = options.meshopt ? compress_gltf(views) : views.joined();
}

void reorder_gltf(GltfViews& views, WriteReport& report) {
  std::size_t begin = 0;  // of a part's vertices, among those of all parts of triangles
  std::vector<std::uint32_t>& first = report.first_vertex;
  for (const Json& mesh : views.json().contains("meshes") ? views.json()["meshes"] : Json::array())
    for (const Json& part : mesh.at("primitives")) {
      if (!shows_triangles(part)) continue;
      const auto vertices = views.accessor(part.at("attributes").at("POSITION").get<std::size_t>())
                                .at("count")
                                .get<std::size_t>();
      const auto number = reorder_part(views, part);
      if (number && first.empty() && begin == 0) {  // they were the same so far
        first.resize(vertices);
        std::iota(first.begin(), first.end(), 0U);
      }
      if (number)
        for (std::uint32_t& vertex : first)
          if (vertex >= begin && vertex - begin < vertices)
            vertex = static_cast<std::uint32_t>(begin + (*number)[vertex - begin]);
      begin += vertices;
    }
}

std::string compress_gltf(GltfViews& views) {
  meshopt_encodeVertexVersion(0);  // those of the extension
  meshopt_encodeIndexVersion(1);
  std::vector<Packing> packings;
  std::vector<GltfViews::View> plain = views.views();
  for (std::size_t i = 0; i < plain.size(); ++i) {
    packings.push_back(packing_of(views, i));
    if (packings[i].mode != nullptr) views.views()[i].bytes = packed(plain[i].bytes, packings[i]);
  }
  std::string buffer = views.joined();
  Json& json = views.json();
  std::size_t end = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (packings[i].mode == nullptr) continue;
    Json& view = json["bufferViews"][i];
    view["extensions"][kCompression] = {{"buffer", 0},
                                        {"byteOffset", view["byteOffset"]},
                                        {"byteLength", view["byteLength"]},
                                        {"byteStride", packings[i].stride},
                                        {"count", plain[i].bytes.size() / packings[i].stride},
                                        {"mode", packings[i].mode}};
    view["buffer"] = 1;
    view["byteOffset"] = end;
    view["byteLength"] = plain[i].bytes.size();
    end += (plain[i].bytes.size() + 3) / 4 * 4;
  }
  if (end == 0) return buffer;
  json["buffers"].push_back({{"byteLength", end}, {"extensions", {{kCompression, {{"fallback", true}}}}}});
  use_gltf_extension(json, kCompression, true);
  return buffer;
}

}  // namespace whittle::files
