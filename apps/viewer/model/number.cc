#include "model/number.hh"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace whittle::viewer {

double rounded(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
  return std::strtod(text, nullptr);
}

std::optional<double> to_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string figure(double value) {
  return text::significant(value, 4);
}

}  // namespace whittle::viewer
