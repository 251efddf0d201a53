#include "files/scene_images.hh"

#include <string>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/companions.hh"
#include "files/gltf_uri.hh"
#include "files/image_type.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

/// The view takes the place of the file's name.
void embed_image(GltfOutput& output, std::size_t number, const std::string& bytes) {
  const std::size_t view = output.add_view(bytes);
  GltfOutput::Json& image = output.json()["images"][number];
  if (const ImageType* type = image_type(bytes)) image["mimeType"] = type->mime;
  if (!image.contains("mimeType")) image["mimeType"] = "application/octet-stream";
  if (!image.contains("name")) image["name"] = decode_percents(image["uri"].get<std::string>());
  image.erase("uri");
  image["bufferView"] = view;
}

}  // namespace

void carry_images(const Scene& scene, const fs::path& path, bool into_glb, GltfOutput& output, Encoded& out) {
  if (!output.json().contains("images")) return;
  CompanionCopier copier(path, out.companions);
  for (std::size_t i = 0; i < output.json()["images"].size(); ++i) {
    GltfOutput::Json& image = output.json()["images"][i];
    if (!image.contains("uri") || !image["uri"].is_string()) continue;
    const std::string uri = image["uri"].get<std::string>();
    if (is_data_uri(uri)) continue;
    const std::string name = decode_percents(uri);
    const auto from = beside(scene.path, name);
    if (!into_glb && from && is_same_file(*from, path.parent_path() / name)) continue;
    const auto bytes = into_glb && from ? bytes_of(*from, CompanionCopier::kMost) : std::nullopt;
    const std::string copied = !into_glb && from ? copier.copy(*from) : "";
    if (bytes)
      embed_image(output, i, *bytes);
    else if (!copied.empty())
      image["uri"] = encode_percents(copied);
    else
      leave_out(out.report,
                "image " + in_quotes(name) + ", which is not in the input's folder; it is still named");
  }
}

}  // namespace whittle::files
