#include "files/PlyTextures.hh"

#include <algorithm>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/image_names.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

bool fits_a_line(const std::string& name) {
  return std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' '; });
}

}  // namespace

void PlyTextures::finish(const std::vector<std::string>& names, const fs::path& path, MeshFile& file) {
  if (!any()) return;
  add_faces(file.mesh.triangles.size());
  for (const std::string& name : names) {
    const Link link = follow_beside(path, name);
    if (link.is_there)
      file.files_beside.insert(link.path);
    else
      file.report.not_found.insert(name);
    file.parts.images.push_back({name, link.is_there ? link.path : fs::path()});
    Material material;
    material.name = fs::path(name).stem().string();
    material.image = file.parts.images.size() - 1;
    file.parts.materials.push_back(std::move(material));
    file.parts.list.push_back({static_cast<std::uint32_t>(file.parts.list.size()), "", "", ""});
  }
  file.parts.list.push_back({});  // of no image
  file.parts.of_face = std::move(of_face_);
}

PlyImages ply_images(const Parts& parts, const fs::path& path, bool copies, Encoded& out) {
  PlyImages images;
  const std::vector<std::string> names = image_names(parts, path, copies, out);
  std::vector<std::int32_t> of_material;
  bool is_less = false;
  for (const Material& material : parts.materials) {
    const std::string name = material.image ? names[*material.image] : "";
    is_less = is_less || name.empty() || material.colour != Material().colour || material.is_texture_moved();
    of_material.push_back(-1);
    if (name.empty()) continue;
    if (!fits_a_line(name)) {
      leave_out(out.report, "image " + in_quotes(name));
      continue;
    }
    const auto found = std::find(images.names.begin(), images.names.end(), name);
    of_material.back() = static_cast<std::int32_t>(found - images.names.begin());
    if (found == images.names.end()) images.names.push_back(name);
  }
  if (is_less) reduce(out.report, "of the materials only the images of their colours are written");
  for (const std::uint32_t part : parts.of_face) {
    const std::uint32_t material = parts.list[part].material;
    images.of_face.push_back(material == Part::none ? -1 : of_material[material]);
  }
  if (images.names.empty() || std::all_of(images.of_face.begin(), images.of_face.end(),
                                          [&](std::int32_t i) { return i == 0 && images.names.size() == 1; }))
    images.of_face.clear();
  return images;
}

}  // namespace whittle::files
