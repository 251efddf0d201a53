#include "files/image_names.hh"

#include <cctype>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/companions.hh"
#include "files/image_type.hh"

namespace whittle::files {

namespace fs = std::filesystem;

std::vector<std::string> image_names(const Parts& parts, const fs::path& path, bool copies, Encoded& out) {
  const bool is_stream = !has_a_folder(path);
  CompanionCopier copier(path, out.companions);
  std::vector<std::string> names;
  for (const Image& image : parts.images) {
    names.emplace_back();
    if (!image.path.empty()) {
      names.back() = copies && !is_stream
                         ? copier.copy(image.path)
                         : relative_name(image.path, is_stream ? fs::path() : path.parent_path());
    } else if (image.bytes.empty()) {
      names.back() = image.name;
    } else if (is_stream) {
      leave_out(out.report,
                "image " + in_quotes(image.name) + ", beside standard output, a device or a pipe");
    } else {
      names.back() =
          own_name(out.companions, path, image_file_name(image, path.stem().string()), image.bytes);
      out.companions.push_back({path.parent_path() / names.back(), image.bytes});
    }
  }
  return names;
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
