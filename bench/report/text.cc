#include "report/text.hh"

#include <cmath>
#include <cstdio>

namespace whittle::bench {

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string out = text;
  // No sign on a rounded zero.
  if (out[0] == '-' && out.find_first_not_of("-0.") == std::string::npos) out.erase(0, 1);
  return out;
}

std::string thousands(double value) {
  std::string out = fixed(std::abs(value), 0);
  for (auto at = static_cast<long>(out.size()) - 3; at > 0; at -= 3)
    out.insert(static_cast<std::size_t>(at), ",");
  return value < 0 ? "-" + out : out;
}

std::string short_number(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string spread_text(const Summary& s, int decimals) {
  const std::string median = fixed(s.median, decimals);
  if (s.min == s.max) return median;
  return median + " (" + fixed(s.min, decimals) + " to " + fixed(s.max, decimals) + ")";
}

}  // namespace whittle::bench
