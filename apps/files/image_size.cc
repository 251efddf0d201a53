#include "files/image_size.hh"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "files/bytes.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;
using ImageJson = nlohmann::json;

constexpr std::size_t kImageHead = 1 << 18;     // a JPEG may have a preview before its size
constexpr std::size_t kMaterialHead = 1 << 20;  // of an OBJ or a material library
constexpr std::size_t kMostJson = 1 << 26;

/// The bytes of a regular file from a place on, at most so many; empty where there are none.
std::string part_of(const fs::path& path, std::size_t first, std::size_t most) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string bytes(most, '\0');
  file.seekg(static_cast<std::streamoff>(first));
  file.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
  return bytes;
}

/// A file that another one names, if it is in the folder of that or below.
std::optional<fs::path> beside(const fs::path& file, const std::string& name) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (name.empty() || relative.is_absolute() || *relative.begin() == "..") return std::nullopt;
  return file.parent_path() / relative;
}

std::optional<ImageSize> size_of_file(const std::optional<fs::path>& path) {
  return path ? image_size(part_of(*path, 0, kImageHead)) : std::nullopt;
}

std::optional<ImageSize> checked_size(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) return std::nullopt;
  return ImageSize{width, height};
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Goes from segment to segment to the one that begins the frame.
std::optional<ImageSize> jpeg_size(std::string_view bytes) {
  for (std::size_t at = 2; at + 9 <= bytes.size();) {
    if (big_endian(bytes, at, 1) != 0xff) return std::nullopt;
    const std::uint32_t kind = big_endian(bytes, at + 1, 1);
    if (kind == 0xff) {  // filling
      ++at;
      continue;
    }
    const bool is_frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (is_frame) return checked_size(big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2));
    at += 2 + big_endian(bytes, at + 2, 2);
  }
  return std::nullopt;
}

/// What follows a keyword at the beginning of a line, without blanks around it; empty where no line begins so.
std::string after_keyword(const std::string& text, const std::string& keyword) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line.compare(first, keyword.size(), keyword) != 0) continue;
    const std::size_t end = first + keyword.size();
    if (end >= line.size() || std::isspace(static_cast<unsigned char>(line[end])) == 0) continue;
    const std::size_t begin = line.find_first_not_of(" \t\r", end);
    return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
  }
  return {};
}

std::optional<ImageSize> size_for_obj(const fs::path& mesh) {
  const auto library = beside(mesh, after_keyword(part_of(mesh, 0, kMaterialHead), "mtllib"));
  if (!library) return std::nullopt;
  std::string image = after_keyword(part_of(*library, 0, kMaterialHead), "map_Kd");
  if (!image.empty() && image.front() == '-') image.erase(0, image.find_last_of(" \t") + 1);  // options first
  return size_of_file(beside(*library, image));
}

/// The number at the end of a chain of names, as in materials/0/…/index.
std::optional<std::size_t> number_at(const ImageJson& json, const std::string& pointer) {
  const ImageJson::json_pointer place(pointer);
  if (!json.contains(place) || !json.at(place).is_number_unsigned()) return std::nullopt;
  return json.at(place).get<std::size_t>();
}

std::optional<ImageSize> size_for_glb(const fs::path& mesh) {
  const std::string head = part_of(mesh, 0, 20);
  if (head.size() < 20) return std::nullopt;
  const std::size_t length = load<std::uint32_t>(head.data() + 12, ByteOrder::little);
  const ImageJson json = ImageJson::parse(part_of(mesh, 20, std::min(length, kMostJson)), nullptr, false);
  const auto texture = number_at(json, "/materials/0/pbrMetallicRoughness/baseColorTexture/index");
  if (!texture) return std::nullopt;
  const auto source = number_at(json, "/textures/" + std::to_string(*texture) + "/source");
  if (!source) return std::nullopt;
  const std::string image = "/images/" + std::to_string(*source);
  const ImageJson::json_pointer uri(image + "/uri");
  if (json.contains(uri) && json.at(uri).is_string())
    return size_of_file(beside(mesh, json.at(uri).get<std::string>()));
  const auto view = number_at(json, image + "/bufferView");
  if (!view) return std::nullopt;
  const std::string where = "/bufferViews/" + std::to_string(*view);
  if (number_at(json, where + "/buffer").value_or(1) != 0) return std::nullopt;
  const std::size_t first = 20 + length + 8 + number_at(json, where + "/byteOffset").value_or(0);
  return image_size(
      part_of(mesh, first, std::min(kImageHead, number_at(json, where + "/byteLength").value_or(0))));
}

}  // namespace

std::optional<ImageSize> image_size(std::string_view bytes) {
  constexpr std::string_view png = "\x89PNG\r\n\x1a\n", jpeg = "\xff\xd8";
  if (bytes.substr(0, png.size()) == png && bytes.size() >= 24)
    return checked_size(big_endian(bytes, 16, 4), big_endian(bytes, 20, 4));
  if (bytes.substr(0, jpeg.size()) == jpeg) return jpeg_size(bytes);
  return std::nullopt;
}

std::optional<ImageSize> texture_image_size(const fs::path& mesh) {
  std::string extension = mesh.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".obj") return size_for_obj(mesh);
  return extension == ".glb" ? size_for_glb(mesh) : std::nullopt;
}

}  // namespace whittle::files
