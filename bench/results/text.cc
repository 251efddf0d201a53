#include "results/text.hh"

#include <cstdio>

#include "text/number.hh"

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
  return text::grouped(fixed(value, 0));
}

std::string short_number(double value) {
  return text::significant(value, 3);
}

std::string spread_text(const Summary& s, int decimals) {
  const std::string median = fixed(s.median, decimals);
  if (s.min == s.max) return median;
  return median + " (" + fixed(s.min, decimals) + " to " + fixed(s.max, decimals) + ")";
}

}  // namespace whittle::bench
