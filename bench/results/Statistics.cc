#include "results/Statistics.hh"

#include <algorithm>
#include <cstddef>

namespace whittle::bench {

Summary summarise(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  return {median, values.front(), values.back()};
}

double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double improvement_percent(double original_time, double time) {
  return 100 * (original_time / time - 1);
}

double frame_time_fall_percent(double original_time, double time) {
  return 100 * (1 - time / original_time);
}

}  // namespace whittle::bench
