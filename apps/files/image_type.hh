/// \file
/// Which kind of image bytes are.
#pragma once

#include <string_view>

namespace whittle::files {

struct ImageType {
  const char* mime;
  const char* extension;  ///< of a file, with its dot
  bool is_plain;          ///< glTF takes it without an extension
};

/// As the bytes begin: PNG, JPEG, WebP or KTX 2; null where they are none of these.
const ImageType* image_type(std::string_view bytes);

/// Whether bytes are of these or of another kind that materials name: BMP, DDS, GIF, OpenEXR, Photoshop, Radiance, TIFF
/// or TGA.
bool is_image(std::string_view bytes);

}  // namespace whittle::files
