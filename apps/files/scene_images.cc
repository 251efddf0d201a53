#include "files/scene_images.hh"

#include <map>
#include <optional>
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

struct EmbeddedImage {
  std::optional<std::size_t> view = {};  ///< none: the file cannot be read
  const ImageType* type = nullptr;       ///< null: unknown
};

/// The view takes the place of the file's name.
void embed_image(GltfOutput::Json& image, const EmbeddedImage& embedded) {
  if (embedded.type) image["mimeType"] = embedded.type->mime;
  if (!image.contains("mimeType")) image["mimeType"] = "application/octet-stream";
  if (!image.contains("name")) image["name"] = decode_percents(image["uri"].get<std::string>());
  image.erase("uri");
  image["bufferView"] = *embedded.view;
}

/// The file's bytes are in the data once, however many images it is.
EmbeddedImage embedded(GltfOutput& output, const fs::path& file) {
  const auto bytes = bytes_of(file, CompanionCopier::kMost);
  if (!bytes) return {};
  return {output.add_view(*bytes), image_type(*bytes)};
}

/// One that is not carried over: its name leads to the same place from the result, where that can be.
void rename_image(const Scene& scene, const fs::path& path, const Link& link, const std::string& name,
                  GltfOutput::Json& image, Encoded& out) {
  const Link anywhere = follow(scene.path, name);
  std::string now = name;
  if (!anywhere.path.empty()) {
    now = relative_name(anywhere.path, path == "-" ? fs::path() : path.parent_path());
    image["uri"] = encode_percents(now);
  }
  out.report.lost_files.push_back(
      "the image " + (link.refusal.empty() ? "'" + name + "' is missing" : link.refusal + ", is refused") +
      "; the result names it " + (now == name ? "as it was" : "'" + now + "'"));
}

}  // namespace

void carry_images(const Scene& scene, const fs::path& path, bool into_glb, GltfOutput& output, Encoded& out) {
  if (!output.json().contains("images")) return;
  CompanionCopier copier(path, out.companions);
  std::map<fs::path, EmbeddedImage> known;
  std::map<std::string, Link> links;
  for (std::size_t i = 0; i < output.json()["images"].size(); ++i) {
    GltfOutput::Json& image = output.json()["images"][i];
    if (!image.contains("uri") || !image["uri"].is_string()) continue;
    const std::string uri = image["uri"].get<std::string>();
    if (is_data_uri(uri)) continue;
    const std::string name = decode_percents(uri);
    const auto [place, is_new] = links.emplace(name, Link());
    if (is_new) place->second = follow_beside(scene.path, name);
    const Link& link = place->second;
    const auto from = link.is_there ? std::optional(link.path) : std::nullopt;
    if (!into_glb && from && is_same_file(*from, path.parent_path() / name)) continue;
    if (into_glb && from && known.count(*from) == 0) known.emplace(*from, embedded(output, *from));
    const EmbeddedImage inside = into_glb && from ? known.at(*from) : EmbeddedImage();
    const std::string copied = !into_glb && from ? copier.copy(*from) : "";
    if (inside.view)
      embed_image(image, inside);
    else if (!copied.empty())
      image["uri"] = encode_percents(copied);
    else
      rename_image(scene, path, link, name, image, out);
  }
}

}  // namespace whittle::files
