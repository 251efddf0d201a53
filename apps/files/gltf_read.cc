/// \file
/// glTF 2.0: reading, from the binary container or from JSON with all data inside.
#include <tiny_gltf.h>

#include <limits>

#include "files/Fault.hh"
#include "files/GltfScene.hh"
#include "files/base64.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/gltf_document.hh"

namespace whittle::files {
namespace {

constexpr std::string_view magic = "glTF";
constexpr std::size_t header_bytes = 12;  // magic, version, length
constexpr std::uint32_t json_chunk = 0x4e4f534a;
constexpr std::uint32_t binary_chunk = 0x004e4942;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  return load<std::uint32_t>(bytes.data() + at, ByteOrder::little);
}

struct Container {
  std::string_view json;
  std::string_view binary;  ///< empty where there is none
};

std::string_view take_chunk(std::string_view& rest, std::uint32_t type, const char* what) {
  if (rest.size() < 8) throw Fault(std::string("the file is cut off: it has no ") + what);
  if (word_at(rest, 4) != type) throw Fault(std::string("expected ") + what);
  const std::size_t length = word_at(rest, 0);
  if (length > rest.size() - 8) throw Fault("the file is cut off");
  const std::string_view chunk = rest.substr(8, length);
  rest.remove_prefix(8 + length);
  return chunk;
}

Container open_container(std::string_view bytes, MeshBuilder& builder) {
  if (bytes.size() < header_bytes) throw Fault("the file is cut off: too short for a GLB header");
  if (!is_glb(bytes)) throw Fault("not a GLB file: it does not begin with 'glTF'");
  if (word_at(bytes, 4) != 2)
    throw Fault("glTF version " + std::to_string(word_at(bytes, 4)) + " is not supported");
  const std::size_t length = word_at(bytes, 8);
  if (length < header_bytes || length > bytes.size()) throw Fault("the file is cut off");
  if (length < bytes.size()) builder.ignore("bytes after the last chunk");
  std::string_view rest = bytes.substr(header_bytes, length - header_bytes);
  Container container;
  container.json = take_chunk(rest, json_chunk, "JSON");
  if (rest.size() >= 8 && word_at(rest, 4) == binary_chunk)
    container.binary = take_chunk(rest, binary_chunk, "binary data");
  if (!rest.empty()) builder.ignore("other chunks");
  return container;
}

/// \param uri  `data:` something `;base64,` something
std::string decode_data_uri(std::string_view uri) {
  if (uri.substr(0, 5) != "data:")
    throw Fault("its data are in the file " + in_quotes(uri) + "; glTF is read only with all data inside");
  const std::size_t comma = uri.find(',');
  constexpr std::string_view base64 = ";base64";
  if (comma == std::string_view::npos || comma < base64.size() ||
      uri.substr(comma - base64.size(), base64.size()) != base64)
    throw Fault("its data are not in base64");
  return decode_base64(uri.substr(comma + 1));
}

/// The bytes of all buffers, in the file or decoded.
class Buffers {
 public:
  Buffers(const std::vector<GltfBuffer>& declared, std::string_view binary) {
    decoded_.reserve(declared.size());  // so that none of them moves
    for (const GltfBuffer& buffer : declared) {
      std::string_view bytes = views_.empty() ? binary : std::string_view();
      if (buffer.has_uri) bytes = decoded_.emplace_back(decode_data_uri(buffer.uri));
      if (buffer.bytes > bytes.size()) throw Fault("the file is cut off: a buffer is longer than its data");
      views_.push_back(bytes.substr(0, buffer.bytes));
    }
  }

  const std::vector<std::string_view>& views() const { return views_; }

 private:
  std::vector<std::string> decoded_;
  std::vector<std::string_view> views_;
};

tinygltf::Model parse_model(const std::string& json) {
  if (json.size() > std::numeric_limits<unsigned>::max()) throw Fault("its JSON is too long");
  tinygltf::Model model;
  std::string error, warning;
  bool good = false;
  try {
    good = tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, json.data(),
                                                    static_cast<unsigned>(json.size()), "");
  } catch (const std::exception&) {
    // A value of another type than the library expects.
  }
  if (!good) throw Fault("its JSON is damaged: a value is missing or of the wrong type");
  return model;
}

void read_document(std::string_view json, std::string_view binary, MeshFile& file, MeshBuilder& builder) {
  const GltfDocument document = parse_gltf(json, builder);
  const tinygltf::Model model = parse_model(document.json);
  const Buffers buffers(document.buffers, binary);
  GltfData data(model, buffers.views(), json.size() + binary.size());
  GltfScene scene(file, builder, data);
  for (const GltfInstance& instance : document.instances) {
    if (instance.mesh >= model.meshes.size()) throw Fault("a mesh that is not there");
    for (const tinygltf::Primitive& primitive : model.meshes[instance.mesh].primitives)
      scene.add(primitive, instance.transform);
  }
  scene.finish();
}

}  // namespace

bool is_glb(std::string_view bytes) {
  return bytes.substr(0, magic.size()) == magic;
}

MeshFile read_glb(std::string_view bytes, const ReadOptions& options) {
  MeshFile file;
  file.report.format = "glTF, binary";
  MeshBuilder builder(file, options);
  const Container container = open_container(bytes, builder);
  read_document(container.json, container.binary, file, builder);
  return file;
}

MeshFile read_gltf(std::string_view bytes, const ReadOptions& options) {
  MeshFile file;
  file.report.format = "glTF, JSON";
  MeshBuilder builder(file, options);
  read_document(bytes, {}, file, builder);
  return file;
}

}  // namespace whittle::files
