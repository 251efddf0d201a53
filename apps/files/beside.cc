#include "files/beside.hh"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace whittle::files {

namespace fs = std::filesystem;

namespace {

bool is_within(const fs::path& folder, const fs::path& path) {
  const auto end = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end.first == folder.end();
}

fs::path folder_of_file(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

/// Why a name is not followed wherever it leads; empty: it is.
std::string refusal_of(const fs::path& file, const std::string& name) {
  if (file == "-") return "as standard input has no folder";
  if (name[0] != '/' && is_file(file.parent_path() / name)) return "";
  if (is_url(name)) return "a URL";
  const bool has_drive =
      name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0]));
  return name[0] == '/' || name[0] == '\\' || has_drive ? "an absolute path" : "";
}

}  // namespace

std::optional<fs::path> beside(const fs::path& file, const std::string& name) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (file == "-" || name.empty() || relative.is_absolute() || *relative.begin() == "..") return std::nullopt;
  const fs::path path = file.parent_path() / relative;
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(folder_of_file(file), error);
  const fs::path resolved = fs::weakly_canonical(folder_of_file(file) / relative, error);
  if (error || !is_within(folder, resolved)) return std::nullopt;
  return path;
}

bool is_url(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos || colon < 2) return false;
  return std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(colon), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
  });
}

Link follow(const fs::path& file, const std::string& name) {
  Link link;
  if (name.empty()) return link;
  if (const std::string why = refusal_of(file, name); !why.empty()) {
    link.refusal = quoted(name) + ", " + why;
    return link;
  }
  link.path = file.parent_path() / name;
  if (!is_file(link.path)) {
    std::string slashed = name;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    link.path = (file.parent_path() / slashed).lexically_normal();
    link.is_inside = beside(file, slashed).has_value();
  } else {
    link.is_inside = beside(file, name).has_value();
  }
  link.is_there = is_file(link.path);
  return link;
}

Link follow_beside(const fs::path& file, const std::string& name) {
  Link link = follow(file, name);
  const auto inside = beside(file, name);
  link.is_inside = inside.has_value();
  link.path = inside.value_or(fs::path());
  link.is_there = inside && is_file(*inside);
  if (!inside && !name.empty() && link.refusal.empty())
    link.refusal = quoted(name) + ", which leads out of its folder";
  return link;
}

std::optional<std::string> bytes_of(const fs::path& path, std::size_t most) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size > most) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) return std::nullopt;
  return bytes;
}

std::string relative_name(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path from = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  // The last name stays as it is, also where it is a link.
  const fs::path to = fs::weakly_canonical(folder_of_file(path), error) / path.filename();
  return error ? path.generic_string() : to.lexically_proximate(from).generic_string();
}

}  // namespace whittle::files
