/// \file
/// How different two pictures look: PSNR and SSIM of their luma.
#pragma once

#include <vector>

#include "render/Image.hh"

namespace whittle::bench {

/// Luma is 0.299 R + 0.587 G + 0.114 B of the eight-bit values. Only pixels count where at least one of the
/// two pictures shows something other than the background, which would else make everything look alike.
struct ImageDifference {
  double squared_error = 0;  ///< mean over those pixels
  double ssim = 1;           ///< mean over those pixels; 1 is the same picture
};

/// SSIM after Wang, Bovik, Sheikh and Simoncelli (2004): Gaussian window of 11 x 11 pixels with a standard
/// deviation of 1.5, C1 = (0.01·255)², C2 = (0.03·255)²; beyond the border the picture goes on as its last
/// pixel. The background is the colour of each picture's first pixel.
/// \pre both pictures have the same size and at least one pixel.
ImageDifference image_difference(const render::Image& a, const render::Image& b);

/// 10·log10(255² / squared error), in dB; kSamePicture where there is no error.
double psnr(double squared_error);
constexpr double kSamePicture = 99;

/// Many views together: the PSNR of the mean squared error, the mean SSIM, and the worst of each.
struct ViewsDifference {
  double psnr_db = kSamePicture, psnr_worst_db = kSamePicture, ssim = 1, ssim_worst = 1;
};
ViewsDifference views_difference(const std::vector<render::Image>& a, const std::vector<render::Image>& b);

}  // namespace whittle::bench
