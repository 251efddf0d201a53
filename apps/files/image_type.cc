#include "files/image_type.hh"

namespace whittle::files {

const ImageType* image_type(std::string_view bytes) {
  static constexpr ImageType png = {"image/png", ".png", true}, jpeg = {"image/jpeg", ".jpg", true},
                             webp = {"image/webp", ".webp", false}, ktx2 = {"image/ktx2", ".ktx2", false};
  if (bytes.substr(0, 4) == "\x89PNG") return &png;
  if (bytes.substr(0, 3) == "\xff\xd8\xff") return &jpeg;
  if (bytes.substr(0, 4) == "RIFF") return &webp;
  return bytes.size() > 1 && bytes.substr(1, 6) == "KTX 20" ? &ktx2 : nullptr;
}

}  // namespace whittle::files
