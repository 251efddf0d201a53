#include "files/obj_materials.hh"

#include <algorithm>
#include <cctype>
#include <map>

#include "files/Choice.hh"
#include "files/beside.hh"
#include "files/mtl.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCopied = std::size_t{1} << 31;  // bytes of one file

/// The file that a companion would be is what it is copied from.
bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

/// Copies a file beside another one.
/// \return the name of the copy; empty where there is nothing to copy
std::string copy_beside(std::vector<Companion>& companions, const fs::path& path, const fs::path& from,
                        std::map<fs::path, std::string>& known) {
  if (const auto found = known.find(from); found != known.end()) return found->second;
  std::string& name = known[from];
  const std::string own = from.filename().string();
  if (is_same_file(from, path.parent_path() / own)) return name = own;
  auto bytes = bytes_of(from, kMostCopied);
  return name = bytes ? add_companion(companions, path, own, std::move(*bytes)) : "";
}

class LibraryCopier {
 public:
  LibraryCopier(const fs::path& path, std::vector<Companion>& companions)
      : path_(path), companions_(companions) {}

  /// \return what the new file calls it
  std::string copy(const Library& library) {
    const auto text = bytes_of(library.path, kMostCopied);
    if (!text) return relative_name(library.path, path_.parent_path());
    std::string own = library.path.filename().string();
    const std::string renamed = with_images(*text, [&](const std::string& image) {
      const auto from = beside(library.path, image);
      const std::string copied = from ? copy_beside(companions_, path_, *from, known_) : "";
      return copied.empty() ? image : copied;
    });
    if (is_same_file(library.path, path_.parent_path() / own) && renamed == *text) return own;
    return add_companion(companions_, path_, own, renamed);
  }

 private:
  const fs::path& path_;
  std::vector<Companion>& companions_;
  std::map<fs::path, std::string> known_;  // where images have been copied to
};

ObjMaterials own_library(const Parts& parts, const fs::path& path, bool copies) {
  ObjMaterials out;
  const std::string stem = path.stem().string();
  std::vector<std::string> names;
  std::map<fs::path, std::string> known;
  for (const Image& image : parts.images) {
    if (image.path.empty() && !image.bytes.empty()) {
      names.push_back(add_companion(out.companions, path, image_file_name(image, stem), image.bytes));
      out.companions.back().owner = path.parent_path() / (stem + ".mtl");
    } else if (image.path.empty())
      names.push_back(image.name);
    else
      names.push_back(copies ? copy_beside(out.companions, path, image.path, known)
                             : relative_name(image.path, path.parent_path()));
  }
  out.libraries.push_back(add_companion(out.companions, path, stem + ".mtl", mtl_text(parts, names)));
  out.companions.back().owner = path;
  return out;
}

}  // namespace

ObjMaterials obj_materials(const Parts& parts, const fs::path& path, bool copies, WriteReport& report) {
  ObjMaterials out;
  if (!parts.has_materials()) return out;
  if (!parts.in_libraries) {
    if (path != "-") return own_library(parts, path, copies);
    leave_out(report, "materials, beside standard output");
    return out;
  }
  const fs::path folder = path == "-" ? fs::path() : path.parent_path();
  LibraryCopier copier(path, out.companions);
  for (const Library& library : parts.libraries) {
    const bool is_placed = !library.path.empty() && !fs::path(library.name).is_absolute();
    if (!is_placed)
      out.libraries.push_back(library.name);
    else if (copies && path != "-")
      out.libraries.push_back(copier.copy(library));
    else
      out.libraries.push_back(relative_name(library.path, folder));
  }
  return out;
}

std::string add_companion(std::vector<Companion>& companions, const fs::path& file, const std::string& name,
                          std::string bytes) {
  const fs::path wanted = name;
  std::string free = name;
  const auto is_taken = [&](const std::string& text) {
    return text == file.filename() || std::any_of(companions.begin(), companions.end(), [&](const auto& one) {
             return one.path.filename() == text;
           });
  };
  for (int i = 1; is_taken(free); ++i)
    free = wanted.stem().string() + "-" + std::to_string(i) + wanted.extension().string();
  companions.push_back({file.parent_path() / free, std::move(bytes), {}});
  return free;
}

std::string image_file_name(const Image& image, const std::string& prefix) {
  std::string name;
  for (const char c : fs::path(image.name).stem().string()) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    name += is_plain ? c : '_';
  }
  constexpr std::size_t longest = 64;
  const std::string_view bytes = image.bytes;
  const char* extension = bytes.substr(0, 4) == "\x89PNG"    ? ".png"
                          : bytes.substr(0, 2) == "\xff\xd8" ? ".jpg"
                          : bytes.substr(0, 4) == "RIFF"     ? ".webp"
                          : bytes.substr(1, 6) == "KTX 20"   ? ".ktx2"
                                                             : ".img";
  return prefix + "-" + (name.empty() ? "image" : name.substr(0, longest)) + extension;
}

}  // namespace whittle::files
