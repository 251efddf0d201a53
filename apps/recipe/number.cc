#include "recipe/number.hh"

#include <charconv>
#include <cmath>

namespace whittle::recipe {

std::optional<std::pair<double, std::string>> leading_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return std::pair(value, std::string(rest, end));
}

std::optional<double> to_number(const std::string& text) {
  const auto number = leading_number(text);
  if (!number || !number->second.empty()) return std::nullopt;
  return number->first;
}

}  // namespace whittle::recipe
