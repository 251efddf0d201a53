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

bool is_image(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::string_view begins[] = {"BM"sv,   "DDS "sv,         "GIF8"sv,     "v/1\x01"sv,
                                         "8BPS"sv, "#?RADIANCE\n"sv, "II\x2a\0"sv, "MM\0\x2a"sv};
  if (image_type(bytes) != nullptr) return true;
  for (const std::string_view begin : begins)
    if (bytes.substr(0, begin.size()) == begin) return true;
  constexpr std::string_view tga = "TRUEVISION-XFILE.\0"sv;
  return bytes.size() >= tga.size() && bytes.substr(bytes.size() - tga.size()) == tga;
}

}  // namespace whittle::files
