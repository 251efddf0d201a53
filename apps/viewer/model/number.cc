#include "model/number.hh"

#include <cstdio>
#include <cstdlib>

namespace whittle::viewer {

double rounded(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
  return std::strtod(text, nullptr);
}

std::string figure(double value) {
  return text::significant(value, 4);
}

}  // namespace whittle::viewer
