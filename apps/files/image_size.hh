/// \file
/// How large the image is that a mesh has for a texture, from its header alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace whittle::files {

struct ImageSize {
  std::uint32_t width = 0, height = 0;  ///< pixels, positive
};

/// Of a PNG or a JPEG by its first bytes; none if it is neither, or the size is not among them.
std::optional<ImageSize> image_size(std::string_view bytes);

/// Of the image that gives the first material of a mesh file its colours: inside a GLB or beside it, or what the
/// material library of an OBJ names. Only images in the file's folder and below are looked at. None where there is no
/// such image, or the mesh is of another format or comes from standard input.
std::optional<ImageSize> texture_image_size(const std::filesystem::path& mesh);

}  // namespace whittle::files
