#include "chart/Axis.hh"

#include <algorithm>
#include <cmath>

#include "text/number.hh"

namespace whittle::chart {

std::vector<double> linear_ticks(double low, double high, int about) {
  if (low == high) {
    high += low == 0 ? 1 : std::abs(low) / 2;
    low -= low == 0 ? 0 : std::abs(low) / 2;
  }
  const double rough = (high - low) / about;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= rough * 0.999999) step = factor * power;
  std::vector<double> ticks;
  const auto first = std::llround(std::floor(low / step + 1e-9));
  const auto last = std::llround(std::ceil(high / step - 1e-9));
  for (auto i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

std::vector<double> log_ticks(double low, double high) {
  const double decades = std::log10(high / low);
  const std::vector<double> factors = decades > 3 ? std::vector<double>{1} : std::vector<double>{1, 2, 5};
  std::vector<double> all;
  for (auto power = std::lround(std::floor(std::log10(low)));
       power <= std::lround(std::ceil(std::log10(high))); ++power)
    for (const double factor : factors) all.push_back(factor * std::pow(10, static_cast<double>(power)));
  // Keep the last one at or below the lowest value and the first one at or above the highest.
  auto first = std::upper_bound(all.begin(), all.end(), low * 1.000001);
  if (first != all.begin()) --first;
  auto last = std::lower_bound(first, all.end(), high * 0.999999);
  if (last != all.end()) ++last;
  if (last - first < 2 && last != all.end()) ++last;
  return {first, last};
}

std::string number_text(double value) {
  const std::string out = text::significant(value == 0 ? 0 : value, 6);
  return out.find_first_of("e.n") == std::string::npos ? text::grouped(out) : out;
}

Axis::Axis(double low, double high, double from, double to, Scale scale)
    : scale_(scale),
      ticks_(scale == Scale::linear ? linear_ticks(low, high) : log_ticks(low, high)),
      from_(from),
      to_(to) {}

double Axis::along(double value) const {
  return scale_ == Scale::linear ? value : std::log(value);
}

double Axis::place(double value) const {
  const double low = along(ticks_.front()), high = along(ticks_.back());
  return from_ + (to_ - from_) * (along(value) - low) / (high - low);
}

}  // namespace whittle::chart
