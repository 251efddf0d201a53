/// \file
/// glTF 2.0: reading, from the binary container or from JSON with its data inside or beside it.
#include <tiny_gltf.h>

#include <deque>
#include <limits>
#include <set>

#include "files/Fault.hh"
#include "files/GltfScene.hh"
#include "files/beside.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/gltf_document.hh"
#include "files/gltf_uri.hh"
#include "files/scene_layout.hh"

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

/// The bytes of all buffers, in the file or decoded.
class Buffers {
 public:
  /// \param path  of the document, beside which they may be
  Buffers(const std::vector<GltfBuffer>& declared, std::string_view binary,
          const std::filesystem::path& path) {
    decoded_.reserve(declared.size());  // so that none of them moves
    for (const GltfBuffer& buffer : declared) {
      std::string_view bytes = views_.empty() ? binary : std::string_view();
      if (buffer.has_uri)
        bytes = decoded_.emplace_back(is_data_uri(buffer.uri) ? decode_data_uri(buffer.uri)
                                                              : read_beside(path, buffer.uri));
      if (buffer.is_packed && bytes.empty()) {
        views_.emplace_back();
        continue;
      }
      if (buffer.bytes > bytes.size()) throw Fault("the file is cut off: a buffer is longer than its data");
      views_.push_back(bytes.substr(0, buffer.bytes));
    }
  }

  const std::vector<std::string_view>& views() const { return views_; }

  /// Adds one more.
  void add(std::string bytes) { views_.emplace_back(added_.emplace_back(std::move(bytes))); }

  std::size_t size() const {
    std::size_t bytes = 0;
    for (const std::string_view view : views_) bytes += view.size();
    return bytes;
  }

 private:
  std::vector<std::string> decoded_;
  std::deque<std::string> added_;  // none of which moves
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

/// The scene that the document shows, as one mesh for other formats.
void read_flat(const GltfDocument& document, const tinygltf::Model& model, GltfData& data,
               const std::filesystem::path& path, MeshFile& file, MeshBuilder& builder) {
  GltfScene scene(file, builder, data, nullptr, texture_uses(document.looks));
  for (const GltfInstance& instance : document.instances) {
    if (instance.mesh >= model.meshes.size()) throw Fault("a mesh that is not there");
    for (const tinygltf::Primitive& primitive : model.meshes[instance.mesh].primitives)
      scene.add(primitive, instance.transform, instance.name);
  }
  scene.finish();
  scene.drop_unused();
  read_gltf_materials(document.looks, data, path, file);
}

std::size_t joints_of(const nlohmann::json& document, const nlohmann::json& node) {
  const nlohmann::json::json_pointer list("/joints");
  const nlohmann::json& skins = document["skins"];
  const nlohmann::json& skin = node["skin"];
  if (!skin.is_number_unsigned() || !skins.is_array() || skin.get<std::size_t>() >= skins.size()) return 0;
  const nlohmann::json& joints = skins[skin.get<std::size_t>()];
  return joints.contains(list) && joints[list].is_array() ? joints[list].size() : 0;
}

/// \throw Fault  a vertex follows a joint that the skin of its mesh does not have
void check_joints(const Scene& kept, std::size_t meshes, const MeshFile& file) {
  constexpr auto any = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> joints(meshes, any);
  if (!kept.document.contains("nodes") || !kept.document.contains("skins")) return;
  for (const nlohmann::json& node : kept.document["nodes"])
    if (node.contains("mesh") && node.contains("skin"))
      joints[node["mesh"].get<std::size_t>()] =
          std::min(joints[node["mesh"].get<std::size_t>()], joints_of(kept.document, node));
  for (const attributes::Attribute& skin : file.attributes) {
    if (skin.kind != attributes::Kind::skin) continue;
    for (std::size_t v = 0; v < kept.mesh_of.size() && v < skin.n_values(); ++v)
      for (std::size_t k = 0; k + 1 < skin.components; k += 2) {
        const float* value = skin.value(v) + k;
        const std::size_t count = joints[kept.mesh_of[v]];
        if (value[1] > 0 && count != any && value[0] >= static_cast<float>(count))
          throw Fault("a vertex follows joint " + std::to_string(static_cast<std::size_t>(value[0])) +
                      " of a skin that has " + std::to_string(count) + "; --flatten leaves skins out");
      }
  }
}

/// Each mesh of the document once.
void read_kept(const GltfDocument& document, const tinygltf::Model& model, GltfData& data,
               std::shared_ptr<Scene> kept, MeshFile& file, MeshBuilder& builder) {
  GltfScene scene(file, builder, data, kept.get(), texture_uses(document.looks));
  for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh) {
    const auto& primitives = model.meshes[mesh].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      scene.next(mesh, i);
      scene.add(primitives[i], Eigen::Matrix4d::Identity(), "");
    }
  }
  scene.finish();
  check_joints(*kept, model.meshes.size(), file);
  read_gltf_materials(document.looks, data, kept->path, file, texture_uses(document.looks));
  tell_looks_apart(*kept, file.parts);
  arrange(*kept, document.instances, model.meshes.size(), file);
  scene.drop_unused();
  file.diagonal = kept->diagonal;
  file.scene = std::move(kept);
}

/// The files that a document names.
void note_files(const GltfDocument& document, const std::filesystem::path& path, MeshFile& file) {
  std::error_code error;
  std::set<std::string> seen;
  const auto note = [&](const std::string& uri) {
    if (!seen.insert(uri).second) return;
    const auto beside_it = is_data_uri(uri) ? std::nullopt : beside(path, decode_percents(uri));
    if (beside_it && std::filesystem::is_regular_file(*beside_it, error))
      file.files_beside.insert(*beside_it);
  };
  for (const GltfBuffer& buffer : document.buffers)
    if (buffer.has_uri) note(buffer.uri);
  for (const auto& image : document.looks["images"])
    if (image.is_object() && image.contains("uri") && image["uri"].is_string()) note(image["uri"]);
}

void read_document(std::string_view json, std::string_view binary, const ReadOptions& options,
                   const std::filesystem::path& path, MeshFile& file, MeshBuilder& builder) {
  const GltfDocument document = parse_gltf(json, options.keep_scene, builder);
  tinygltf::Model model = parse_model(document.json);
  note_files(document, path, file);
  Buffers buffers(document.buffers, binary, path);
  std::size_t file_bytes = json.size() + buffers.size();
  if (!document.packed.empty())
    buffers.add(unpacked(document.packed, buffers.views(), GltfData::most_bytes(file_bytes)));
  if (std::string bytes = unpack_draco(document.draco, model, buffers.views(), file_bytes); !bytes.empty()) {
    file_bytes += bytes.size() / 8;  // such files are small for what they hold
    buffers.add(std::move(bytes));
  }
  GltfData data(model, buffers.views(), file_bytes);
  if (!options.keep_scene) return read_flat(document, model, data, path, file, builder);
  auto kept = std::make_shared<Scene>();
  kept->document = whole_gltf(json);
  kept->path = path;
  for (const std::string_view buffer : buffers.views()) kept->buffers.emplace_back(buffer);
  read_kept(document, model, data, std::move(kept), file, builder);
}

}  // namespace

bool is_glb(std::string_view bytes) {
  return bytes.substr(0, magic.size()) == magic;
}

MeshFile read_glb(std::string_view bytes, const ReadOptions& options, const std::filesystem::path& path) {
  MeshFile file;
  file.report.format = "glTF, binary";
  MeshBuilder builder(file, options);
  const Container container = open_container(bytes, builder);
  read_document(container.json, container.binary, options, path, file, builder);
  return file;
}

MeshFile read_gltf(std::string_view bytes, const ReadOptions& options, const std::filesystem::path& path) {
  MeshFile file;
  file.report.format = "glTF, JSON";
  MeshBuilder builder(file, options);
  read_document(bytes, {}, options, path, file, builder);
  return file;
}

}  // namespace whittle::files
