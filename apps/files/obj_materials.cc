#include "files/obj_materials.hh"

#include <cctype>

#include "files/Choice.hh"
#include "files/beside.hh"
#include "files/companions.hh"
#include "files/image_type.hh"
#include "files/mtl.hh"
#include "files/own_companions.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

class LibraryCopier {
 public:
  LibraryCopier(const fs::path& path, std::vector<Companion>& companions)
      : path_(path), companions_(companions), images_(path, companions) {}

  /// \return what the new file calls it
  std::string copy(const Library& library) {
    const auto text = bytes_of(library.path, CompanionCopier::kMost);
    if (!text || !is_library(*text)) return relative_name(library.path, path_.parent_path());
    std::string own = library.path.filename().string();
    const std::string renamed = with_images(*text, [&](const std::string& image) {
      const Link link = follow(library.path, image);
      const std::string copied = link.is_there ? images_.copy(link.path, !link.is_inside) : "";
      if (!copied.empty() || link.path.empty()) return copied.empty() ? image : copied;
      return relative_name(link.path, path_.parent_path());
    });
    if (is_same_file(library.path, path_.parent_path() / own) && renamed == *text) return own;
    return add_companion(companions_, path_, own, renamed);
  }

 private:
  const fs::path& path_;
  std::vector<Companion>& companions_;
  CompanionCopier images_;
};

ObjMaterials own_library(const Parts& parts, const fs::path& path, bool copies) {
  ObjMaterials out;
  const std::string stem = path.stem().string();
  std::vector<std::string> names;
  CompanionCopier copier(path, out.companions);
  for (const Image& image : parts.images) {
    if (image.path.empty() && !image.bytes.empty()) {
      names.push_back(own_name(out.companions, path, image_file_name(image, stem), image.bytes));
      out.companions.push_back({path.parent_path() / names.back(), image.bytes});
    } else if (image.path.empty())
      names.push_back(image.name);
    else
      names.push_back(copies ? copier.copy(image.path) : relative_name(image.path, path.parent_path()));
  }
  std::string text = library_mark(path) + mtl_text(parts, names);
  out.libraries.push_back(own_name(out.companions, path, stem + ".mtl", text));
  out.companions.push_back({path.parent_path() / out.libraries.back(), std::move(text)});
  return out;
}

}  // namespace

ObjMaterials obj_materials(const Parts& parts, const fs::path& path, bool copies, WriteReport& report) {
  ObjMaterials out;
  if (!parts.has_materials()) return out;
  if (!parts.in_libraries) {
    if (has_a_folder(path)) return own_library(parts, path, copies);
    leave_out(report,
              path == "-" ? "materials, beside standard output" : "materials, beside a device or pipe");
    return out;
  }
  const fs::path folder = has_a_folder(path) ? path.parent_path() : fs::path();
  LibraryCopier copier(path, out.companions);
  for (const Library& library : parts.libraries) {
    const bool is_placed = !library.path.empty() && !fs::path(library.name).is_absolute();
    if (!is_placed)
      out.libraries.push_back(library.name);
    else if (copies && has_a_folder(path))
      out.libraries.push_back(copier.copy(library));
    else
      out.libraries.push_back(relative_name(library.path, folder));
  }
  return out;
}

std::string image_file_name(const Image& image, const std::string& prefix) {
  std::string name;
  for (const char c : fs::path(image.name).stem().string()) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    name += is_plain ? c : '_';
  }
  constexpr std::size_t longest = 64;
  const ImageType* type = image_type(image.bytes);
  return prefix + "-" + (name.empty() ? "image" : name.substr(0, longest)) +
         (type == nullptr ? ".img" : type->extension);
}

}  // namespace whittle::files
