/// \file
/// One axis of a chart: from values to places in the picture, and round numbers to mark it with.
#pragma once

#include <string>
#include <vector>

namespace whittle::chart {

enum class Scale { linear, logarithmic };

/// Round numbers (1, 2 or 5 times a power of ten apart) that cover [low, high], about `about` of them.
/// \pre low <= high, both finite.
std::vector<double> linear_ticks(double low, double high, int about = 5);

/// Powers of ten and, where these are few, 2 and 5 times them, that cover [low, high].
/// \pre 0 < low <= high.
std::vector<double> log_ticks(double low, double high);

/// As short as reads well, with a comma between thousands: "0.0013", "25", "12,000", "2e-05".
std::string number_text(double value);

/// Maps values to a stretch of the picture. The first and last tick are its ends.
class Axis {
 public:
  /// \param from,to  where the ends lie in the picture; `to` may be the smaller.
  Axis(double low, double high, double from, double to, Scale scale = Scale::linear);

  double place(double value) const;  ///< values beyond the ends lie beyond the ends
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  double along(double value) const;

  Scale scale_;
  std::vector<double> ticks_;
  double from_, to_;
};

}  // namespace whittle::chart
