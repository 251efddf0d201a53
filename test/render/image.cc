#include "render/Image.hh"

#include <png.h>

#include "catch.hh"
#include "render/GlObject.hh"

using namespace whittle;

namespace {

render::Image read_png(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()));
  png.format = PNG_FORMAT_RGBA;
  render::Image image{static_cast<int>(png.width), static_cast<int>(png.height),
                      std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  REQUIRE(png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr));
  return image;
}

render::Image speckled(int width, int height) {
  render::Image image{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * i * 7 + i));
  return image;
}

}  // namespace

TEST_CASE("a PNG reads back pixel by pixel") {
  for (const auto& [width, height] : {std::pair(1, 1), {7, 3}, {64, 65}}) {
    const auto image = speckled(width, height);
    const auto back = read_png(render::encode_png(image, "a caption"));
    CHECK(back.width == width);
    CHECK(back.height == height);
    CHECK(back.rgba == image.rgba);
  }
}

TEST_CASE("a PNG carries its caption") {
  const auto bytes = render::encode_png(speckled(2, 2), "generated closed mesh");
  CHECK(bytes.find(std::string("Description\0generated closed mesh", 33)) != std::string::npos);
  CHECK(render::encode_png(speckled(2, 2)).find("Description") == std::string::npos);
}

TEST_CASE("an empty image is an error") {
  CHECK_THROWS_AS(render::encode_png({}), render::RenderError);
}

TEST_CASE("pixels are found by column and row from the top") {
  const render::Image image{2, 2, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}};
  CHECK(image.at(1, 0) == std::array<std::uint8_t, 4>{4, 5, 6, 7});
  CHECK(image.at(0, 1) == std::array<std::uint8_t, 4>{8, 9, 10, 11});
}
