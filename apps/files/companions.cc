#include "files/companions.hh"

#include <algorithm>
#include <utility>

#include "files/beside.hh"
#include "files/image_type.hh"
#include "text/hash.hh"

namespace whittle::files {

namespace fs = std::filesystem;

namespace {

bool has_name(const std::vector<Companion>& companions, const std::string& name) {
  return std::any_of(companions.begin(), companions.end(),
                     [&](const Companion& one) { return one.path.filename() == name; });
}

}  // namespace

std::string add_companion(std::vector<Companion>& companions, const fs::path& file, const std::string& name,
                          std::string bytes) {
  const fs::path wanted = name;
  std::string free = name;
  const auto is_taken = [&](const std::string& text) {
    return text == file.filename() || has_name(companions, text);
  };
  for (int i = 1; is_taken(free); ++i)
    free = wanted.stem().string() + "-" + std::to_string(i) + wanted.extension().string();
  companions.push_back({file.parent_path() / free, std::move(bytes)});
  return free;
}

std::string own_name(const std::vector<Companion>& companions, const fs::path& file, const std::string& name,
                     const std::string& bytes) {
  std::error_code error;
  const auto is_there = [&](const std::string& text) {
    return fs::exists(fs::symlink_status(file.parent_path() / text, error));
  };
  const auto is_same = [&](const std::string& text) {
    return bytes_of(file.parent_path() / text, bytes.size()) == bytes;
  };
  const auto is_free = [&](const std::string& text) {
    return text != file.filename() && !has_name(companions, text) && (!is_there(text) || is_same(text));
  };
  // Without an old result there is none to keep whole, and the plain name is as good as before.
  if (!is_there(file.filename().string()) && is_free(name)) return name;
  const fs::path wanted = name;
  const std::string stem = wanted.stem().string() + "-" + text::hash(bytes).substr(0, 8);
  const std::string extension = wanted.extension().string();
  const bool is_kept = is_there(stem + extension) && is_free(stem + extension);  // by the same run before
  if (!is_kept && is_free(name)) return name;
  std::string other = stem + extension;
  for (int i = 1; !is_free(other); ++i) other = stem + "-" + std::to_string(i) + extension;
  return other;
}

std::string CompanionCopier::copy(const fs::path& from, bool only_images) {
  const auto [place, is_new] = known_.emplace(from, "");
  if (!is_new) return place->second;
  const std::string own = from.filename().string();
  if (is_same_file(from, file_.parent_path() / own)) return place->second = own;
  auto bytes = bytes_of(from, kMost);
  if (bytes && only_images && !is_image(*bytes)) bytes.reset();
  return place->second = bytes ? add_companion(companions_, file_, own, std::move(*bytes)) : "";
}

bool has_a_folder(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return file != "-" && (!fs::exists(status) || fs::is_regular_file(status));
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

}  // namespace whittle::files
