#include "files/companions.hh"

#include <algorithm>
#include <utility>

#include "files/beside.hh"
#include "files/image_type.hh"

namespace whittle::files {

namespace fs = std::filesystem;

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

std::string CompanionCopier::copy(const fs::path& from, bool only_images) {
  const auto [place, is_new] = known_.emplace(from, "");
  if (!is_new) return place->second;
  const std::string own = from.filename().string();
  if (is_same_file(from, file_.parent_path() / own)) return place->second = own;
  auto bytes = bytes_of(from, kMost);
  if (bytes && only_images && !is_image(*bytes)) bytes.reset();
  return place->second = bytes ? add_companion(companions_, file_, own, std::move(*bytes)) : "";
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

}  // namespace whittle::files
