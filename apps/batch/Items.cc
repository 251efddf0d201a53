#include "batch/Items.hh"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>

#include "files/MeshFile.hh"

namespace whittle::batch {
namespace {

namespace fs = std::filesystem;

bool is_any_of(const std::vector<std::string>& extensions, const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

bool is_mesh(const fs::path& path) {
  return is_any_of(files::readable_extensions(), path);
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

/// A path as the name of one file: what would be understood otherwise is written as %XX.
std::string flat(const std::string& path) {
  std::string out;
  for (const char c : path) {
    if (c == '/')
      out += "%2F";
    else if (c == '%')
      out += "%25";
    else
      out += c;
  }
  return out;
}

/// Input and where its result goes below the folder of results.
using Found = std::vector<std::pair<fs::path, fs::path>>;

Found in_folder(const fs::path& folder, const fs::path& out) {
  Found found;
  std::error_code error;
  const fs::path here = fs::weakly_canonical(folder, error), there = fs::weakly_canonical(out, error);
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  if (error) throw BatchError(folder.string() + ": " + error.message());
  for (; at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (error) throw BatchError(folder.string() + ": " + error.message());
    const fs::path relative = at->path().lexically_relative(folder);
    if (here != there && is_inside(here / relative, there)) continue;
    if (at->is_regular_file(error) && is_mesh(relative)) found.emplace_back(at->path(), relative);
  }
  std::sort(found.begin(), found.end());
  return found;
}

Found in_manifest(const fs::path& manifest) {
  std::ifstream file(manifest);
  if (!file) throw BatchError(manifest.string() + ": cannot be read");
  Found found;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    if (!is_mesh(line) || line.find('\0') != std::string::npos)
      throw BatchError(manifest.string() + ":" + std::to_string(number) + ": not the name of a mesh file");
    const fs::path path = line;
    found.emplace_back(path.is_absolute() ? path : manifest.parent_path() / path, path.filename());
  }
  if (file.bad()) throw BatchError(manifest.string() + ": cannot be read");
  return found;
}

}  // namespace

std::vector<Item> list_items(const fs::path& source, const fs::path& out, const std::string& format) {
  std::error_code error;
  const bool is_folder = fs::is_directory(source, error);
  if (!is_folder && !fs::exists(source, error)) throw BatchError(source.string() + ": there is no such file");
  std::vector<Item> items;
  std::map<fs::path, fs::path> taken;
  for (auto& [in, relative] : is_folder ? in_folder(source, out) : in_manifest(source)) {
    if (!format.empty())
      relative.replace_extension(format);
    else if (!is_any_of(files::writable_extensions(), relative))
      relative.replace_extension(".glb");  // glTF's one-file form
    const auto [other, is_new] = taken.emplace(relative, in);
    if (!is_new)
      throw BatchError(in.string() + " and " + other->second.string() + " would both become " +
                       (out / relative).string());
    items.push_back({in, out / relative, flat(relative.string())});
  }
  return items;
}

}  // namespace whittle::batch
