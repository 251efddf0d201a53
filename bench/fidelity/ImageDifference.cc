#include "fidelity/ImageDifference.hh"

#include <algorithm>
#include <array>
#include <cmath>

namespace whittle::bench {
namespace {

/// One number a pixel, row by row.
using Plane = std::vector<double>;

Plane luma(const render::Image& image) {
  Plane plane(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (std::size_t i = 0; i < plane.size(); ++i)
    plane[i] = 0.299 * image.rgba[4 * i] + 0.587 * image.rgba[4 * i + 1] + 0.114 * image.rgba[4 * i + 2];
  return plane;
}

constexpr int kRadius = 5;

std::array<double, 2 * kRadius + 1> window() {
  std::array<double, 2 * kRadius + 1> weights{};
  double sum = 0;
  for (int i = -kRadius; i <= kRadius; ++i) sum += weights[i + kRadius] = std::exp(-i * i / (2 * 1.5 * 1.5));
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The window's weighted mean around each pixel, first along rows, then along columns.
Plane blur(const Plane& in, int width, int height) {
  static const auto weights = window();
  Plane rows(in.size()), out(in.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int k = -kRadius; k <= kRadius; ++k)
        sum += weights[k + kRadius] * in[y * width + std::clamp(x + k, 0, width - 1)];
      rows[y * width + x] = sum;
    }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int k = -kRadius; k <= kRadius; ++k)
        sum += weights[k + kRadius] * rows[std::clamp(y + k, 0, height - 1) * width + x];
      out[y * width + x] = sum;
    }
  return out;
}

Plane product(const Plane& a, const Plane& b) {
  Plane out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
  return out;
}

}  // namespace

ImageDifference image_difference(const render::Image& a, const render::Image& b) {
  const int width = a.width, height = a.height;
  const Plane x = luma(a), y = luma(b);
  const auto smooth = [&](const Plane& plane) { return blur(plane, width, height); };
  const Plane mx = smooth(x), my = smooth(y), xx = smooth(product(x, x)), yy = smooth(product(y, y)),
              xy = smooth(product(x, y));
  constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
  const auto background_a = a.at(0, 0), background_b = b.at(0, 0);
  double squared = 0, ssim = 0;
  std::size_t count = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      if (a.at(column, row) == background_a && b.at(column, row) == background_b) continue;
      const std::size_t i = static_cast<std::size_t>(row) * width + column;
      const double vx = xx[i] - mx[i] * mx[i], vy = yy[i] - my[i] * my[i], cov = xy[i] - mx[i] * my[i];
      squared += (x[i] - y[i]) * (x[i] - y[i]);
      ssim +=
          (2 * mx[i] * my[i] + c1) * (2 * cov + c2) / ((mx[i] * mx[i] + my[i] * my[i] + c1) * (vx + vy + c2));
      ++count;
    }
  if (count == 0) return {};
  return {squared / static_cast<double>(count), ssim / static_cast<double>(count)};
}

double psnr(double squared_error) {
  return squared_error > 0 ? std::min(kSamePicture, 10 * std::log10(255.0 * 255.0 / squared_error))
                           : kSamePicture;
}

ViewsDifference views_difference(const std::vector<render::Image>& a, const std::vector<render::Image>& b) {
  ViewsDifference result;
  double squared = 0, ssim = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const ImageDifference view = image_difference(a[i], b[i]);
    squared += view.squared_error;
    ssim += view.ssim;
    result.psnr_worst_db = std::min(result.psnr_worst_db, psnr(view.squared_error));
    result.ssim_worst = std::min(result.ssim_worst, view.ssim);
  }
  if (a.empty()) return result;
  result.psnr_db = psnr(squared / static_cast<double>(a.size()));
  result.ssim = ssim / static_cast<double>(a.size());
  return result;
}

}  // namespace whittle::bench
