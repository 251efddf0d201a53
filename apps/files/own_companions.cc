#include "files/own_companions.hh"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "files/beside.hh"
#include "files/companions.hh"
#include "files/gltf_uri.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// "a.bin", "a-0123abcd.bin" or "a-0123abcd-1.bin", as own_name() makes them.
bool is_own_name(std::string_view name, const fs::path& file, std::string_view extension) {
  const std::string stem = file.stem().string();
  if (name.substr(0, stem.size()) != stem || name.size() < stem.size() + extension.size() ||
      name.substr(name.size() - extension.size()) != extension)
    return false;
  const std::string_view middle = name.substr(stem.size(), name.size() - stem.size() - extension.size());
  constexpr std::size_t digits = 8;
  return middle.empty() || (middle.size() > digits && middle[0] == '-' &&
                            std::all_of(middle.begin() + 1, middle.begin() + 1 + digits,
                                        [](unsigned char c) { return std::isxdigit(c) != 0; }) &&
                            middle.find_first_not_of("-0123456789", 1 + digits) == std::string_view::npos);
}

std::string first_bytes(const fs::path& file, std::size_t most) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return "";
  std::ifstream in(file, std::ios::binary);
  std::string bytes(most, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::vector<fs::path> own_buffers(const fs::path& file) {
  constexpr std::size_t most = std::size_t{1}
                               << 26;  // bytes; with data inside it may be larger, and has none beside it
  std::vector<fs::path> out;
  const auto text = bytes_of(file, most);
  const Json json = Json::parse(text.value_or(""), nullptr, false);
  const Json::json_pointer generator("/asset/generator");
  if (!json.is_object() || !json.contains(generator) || json[generator] != "whittle" ||
      !json.contains("buffers") || !json["buffers"].is_array())
    return out;
  for (const Json& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const std::string name = decode_percents(buffer["uri"].get<std::string>());
    if (is_own_name(name, file, ".bin")) out.push_back(file.parent_path() / name);
  }
  return out;
}

std::vector<fs::path> own_libraries(const fs::path& file, std::string_view begin) {
  std::vector<fs::path> out;
  constexpr std::string_view keyword = "mtllib ";
  while (!begin.empty()) {
    const std::size_t end = begin.find('\n');
    const std::string_view line = begin.substr(0, end);
    begin.remove_prefix(end == std::string_view::npos ? begin.size() : end + 1);
    if (line.substr(0, keyword.size()) != keyword) continue;
    const std::string name(line.substr(keyword.size()));
    const std::string mark = library_mark(file);
    const fs::path library = file.parent_path() / name;
    if (is_own_name(name, file, ".mtl") && first_bytes(library, mark.size()) == mark) out.push_back(library);
  }
  return out;
}

}  // namespace

std::string library_mark(const fs::path& obj) {
  std::string name = obj.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return "# whittle: the materials of " + name + "\n";
}

std::vector<fs::path> own_companions(const fs::path& file) {
  constexpr std::size_t header = 1 << 16;  // bytes: libraries are named before the vertices
  const std::string begin = first_bytes(file, header);
  return begin.empty() || begin[0] != '{' ? own_libraries(file, begin) : own_buffers(file);
}

void OldCompanions::look_at(const fs::path& file) {
  if (std::vector<fs::path> own = own_companions(file); !own.empty()) old_.emplace_back(file, std::move(own));
}

void OldCompanions::remove_unnamed(const std::vector<fs::path>& kept) const {
  for (const auto& [file, companions] : old_) {
    std::vector<fs::path> named = own_companions(file);
    named.insert(named.end(), kept.begin(), kept.end());
    for (const fs::path& companion : companions) {
      const bool stays = std::any_of(named.begin(), named.end(), [&c = companion](const fs::path& other) {
        return is_same_file(c, other);
      });
      std::error_code ignored;  // what cannot be removed is in nobody's way
      if (!stays) fs::remove(companion, ignored);
    }
  }
}

}  // namespace whittle::files
