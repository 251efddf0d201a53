#include "text/number.hh"

#include <charconv>

namespace whittle::text {

std::string shortest(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string significant(double value, int digits) {
  char text[64];  // not printf: its decimal point is the locale's
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

std::string grouped(std::string whole) {
  const std::size_t first = whole[0] == '-' ? 1 : 0;
  for (std::size_t i = whole.size(); i > first + 3; i -= 3) whole.insert(i - 3, ",");
  return whole;
}

std::string grouped(std::size_t count) {
  return grouped(std::to_string(count));
}

}  // namespace whittle::text
