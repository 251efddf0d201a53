/// \file
/// The few figures formed from raw times.
#pragma once

#include <vector>

namespace whittle::bench {

/// The middle of some figures and how far they spread.
struct Summary {
  double median = 0, min = 0, max = 0;
};

/// The median of an even number of values is the mean of the two in the middle.
/// \pre `values` is not empty.
Summary summarise(std::vector<double> values);

/// The value below which a fraction of the values lies, by linear interpolation: 0.25 is the lower quartile,
/// 0.5 the median.
/// \pre `values` is not empty, `fraction` in [0, 1].
double quantile(std::vector<double> values, double fraction);

/// The paper's "improvement": by how much the frames per second rise, in percent. A frame in half the time is
/// +100.
double improvement_percent(double original_time, double time);

/// By how much the time of a frame falls, in percent. A frame in half the time is 50.
double frame_time_fall_percent(double original_time, double time);

}  // namespace whittle::bench
