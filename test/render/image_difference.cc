#include "fidelity/ImageDifference.hh"

#include "catch.hh"

using namespace whittle;

namespace {

/// Grey, but for a first pixel that is black: the background.
render::Image grey(int side, std::uint8_t level) {
  render::Image image{side, side,
                      std::vector<std::uint8_t>(static_cast<std::size_t>(4 * side * side), level)};
  image.rgba[0] = image.rgba[1] = image.rgba[2] = 0;
  return image;
}

}  // namespace

TEST_CASE("a picture does not differ from itself") {
  const auto d = bench::image_difference(grey(20, 100), grey(20, 100));
  CHECK(d.squared_error == 0);
  CHECK(d.ssim == Approx(1));
  CHECK(bench::psnr(0) == bench::kSamePicture);
}

TEST_CASE("PSNR is that of the mean squared error") {
  const auto d = bench::image_difference(grey(20, 100), grey(20, 110));
  CHECK(d.squared_error == Approx(100));
  CHECK(bench::psnr(100) == Approx(28.1308));
}

TEST_CASE("SSIM of two even greys compares the means alone") {
  // The one black pixel in the corner is seen by few windows of many.
  const double c1 = 0.01 * 255 * 0.01 * 255;
  const auto d = bench::image_difference(grey(200, 100), grey(200, 50));
  CHECK(d.ssim == Approx((2 * 100 * 50 + c1) / (100 * 100 + 50 * 50 + c1)).epsilon(0.005));
}

TEST_CASE("two pictures of nothing but background are the same") {
  const render::Image one{1, 1, {0, 0, 0, 255}};
  CHECK(bench::image_difference(one, one).ssim == 1);
  CHECK(bench::image_difference(one, one).squared_error == 0);
}

TEST_CASE("the image difference leaves out the background") {
  auto a = grey(20, 0), b = grey(20, 0);
  const std::size_t middle = 4 * (10 * 20 + 10);
  for (int c = 0; c < 3; ++c) b.rgba[middle + c] = 200;
  CHECK(bench::image_difference(a, b).squared_error == Approx(40000));
}

TEST_CASE("luma weighs green most") {
  auto a = grey(20, 0), b = a;
  const std::size_t middle = 4 * (10 * 20 + 10);
  b.rgba[middle + 1] = 100;
  CHECK(bench::image_difference(a, b).squared_error == Approx(58.7 * 58.7));
}

TEST_CASE("the difference of several views is the mean of the errors, and the worst") {
  const std::vector<render::Image> a = {grey(20, 100), grey(20, 100)}, b = {grey(20, 100), grey(20, 120)};
  const auto d = bench::views_difference(a, b);
  CHECK(d.psnr_db == Approx(bench::psnr(200)));
  CHECK(d.psnr_worst_db == Approx(bench::psnr(400)));
  CHECK(d.ssim_worst < d.ssim);
  CHECK(bench::views_difference({}, {}).ssim == 1);
}
