#include "files/image_size.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

/// The first bytes of a regular file, at most so many; empty where there are none.
std::string head_of(const fs::path& path) {
  constexpr std::size_t most = 1 << 18;  // a JPEG may have a preview before its size
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string bytes(most, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
  return bytes;
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

}  // namespace

std::optional<ImageSize> image_size(std::string_view bytes) {
  constexpr std::string_view png = "\x89PNG\r\n\x1a\n", jpeg = "\xff\xd8";
  if (bytes.substr(0, png.size()) == png && bytes.size() >= 24)
    return checked_size(big_endian(bytes, 16, 4), big_endian(bytes, 20, 4));
  if (bytes.substr(0, jpeg.size()) == jpeg) return jpeg_size(bytes);
  return std::nullopt;
}

std::optional<ImageSize> texture_image_size(const Parts& parts) {
  const auto material = std::find_if(parts.materials.begin(), parts.materials.end(),
                                     [](const Material& one) { return one.image.has_value(); });
  if (material == parts.materials.end()) return std::nullopt;
  const Image& image = parts.images[*material->image];
  const auto size = image.path.empty() ? image_size(image.bytes) : image_size(head_of(image.path));
  if (!size) return std::nullopt;
  const auto times = [](std::uint32_t pixels, double scale) {
    const double all = pixels * std::abs(scale);
    return all >= 1 && all < 1e9 ? static_cast<std::uint32_t>(all + 0.5) : pixels;
  };
  return ImageSize{times(size->width, material->texture_scale[0]),
                   times(size->height, material->texture_scale[1])};
}

}  // namespace whittle::files
