/// \file
/// How large the image is that a mesh has for a texture, from its header alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "files/Parts.hh"

namespace whittle::files {

struct ImageSize {
  std::uint32_t width = 0, height = 0;  ///< pixels, positive
};

/// Of a PNG or a JPEG by its first bytes; none if it is neither, or the size is not among them.
std::optional<ImageSize> image_size(std::string_view bytes);

/// Of the first image that gives a material its base colour, times how often a texture coordinate of 1 is across it. None
/// where there is none, or it is neither PNG nor JPEG.
std::optional<ImageSize> texture_image_size(const Parts& parts);

}  // namespace whittle::files
