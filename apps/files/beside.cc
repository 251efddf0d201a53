#include "files/beside.hh"

#include <algorithm>
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
