#include "files/obj_materials.hh"

#include "files/Choice.hh"
#include "files/beside.hh"
#include "files/companions.hh"
#include "files/image_names.hh"
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

/// \return what the new file calls it
std::string own_library(const Parts& parts, const fs::path& path, bool copies, Encoded& out) {
  const std::vector<std::string> images = image_names(parts, path, copies, out);
  std::string text = library_mark(path) + mtl_text(parts, images);
  std::string name = own_name(out.companions, path, path.stem().string() + ".mtl", text);
  out.companions.push_back({path.parent_path() / name, std::move(text)});
  return name;
}

}  // namespace

std::vector<std::string> obj_materials(const Parts& parts, const fs::path& path, bool copies, Encoded& out) {
  if (!parts.has_materials()) return {};
  if (!parts.in_libraries) {
    if (has_a_folder(path)) return {own_library(parts, path, copies, out)};
    leave_out(out.report,
              path == "-" ? "materials, beside standard output" : "materials, beside a device or pipe");
    return {};
  }
  std::vector<std::string> libraries;
  const fs::path folder = has_a_folder(path) ? path.parent_path() : fs::path();
  LibraryCopier copier(path, out.companions);
  for (const Library& library : parts.libraries) {
    const bool is_placed = !library.path.empty() && !fs::path(library.name).is_absolute();
    if (!is_placed)
      libraries.push_back(library.name);
    else if (copies && has_a_folder(path))
      libraries.push_back(copier.copy(library));
    else
      libraries.push_back(relative_name(library.path, folder));
  }
  return libraries;
}

}  // namespace whittle::files
