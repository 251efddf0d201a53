/// \file
/// libFuzzer's entry to what unpacks Draco: the bytes are a part of a glTF document, of which a Fault comes or a mesh that
/// is sound.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "files/Fault.hh"
#include "files/formats.hh"
#include "files/gltf_samples.hh"
#include "files/sound.hh"

namespace {

using namespace whittle::files;

/// A document whose only part is packed in these bytes, with positions and one more attribute.
std::string document_with(const std::string& packed) {
  Json json = {{"asset", {{"version", "2.0"}}}};
  json["buffers"] = {{{"byteLength", packed.size()}}};
  json["bufferViews"] = {{{"buffer", 0}, {"byteLength", packed.size()}}};
  json["accessors"] = {{{"componentType", 5126}, {"type", "VEC3"}, {"count", 3}},
                       {{"componentType", 5125}, {"type", "SCALAR"}, {"count", 3}}};
  const Json extension = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  json["meshes"] = {{{"primitives",
                      {{{"attributes", {{"POSITION", 0}}},
                        {"indices", 1},
                        {"extensions", {{"KHR_draco_mesh_compression", extension}}}}}}}};
  return glb_of(json.dump(), packed);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    std::size_t line = 0;
    const MeshFile file =
        parse(document_with({reinterpret_cast<const char*>(data), size}), Format::glb, {Repair::fix}, line);
    const char* what = unsound(file);
    if (what == nullptr) return 0;
    std::fprintf(stderr, "%s\n", what);
    std::abort();
  } catch (const Fault&) {
  }
  return 0;
}
