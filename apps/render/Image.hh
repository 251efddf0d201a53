/// \file
/// A picture in memory, and as PNG.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace whittle::render {

/// Eight-bit RGBA, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  /// The pixel in column `x` from the left and row `y` from the top.
  std::array<std::uint8_t, 4> at(int x, int y) const {
    const std::size_t start = 4 * (static_cast<std::size_t>(y) * width + x);
    return {rgba[start], rgba[start + 1], rgba[start + 2], rgba[start + 3]};
  }
};

/// The bytes of a PNG file. A caption goes in as the text chunk "Description", so that a picture which is
/// passed on alone still says what it shows.
/// \throw RenderError  libpng refuses the image, an empty one for example.
std::string encode_png(const Image& image, const std::string& caption = "");

}  // namespace whittle::render
