#include "text/format.hh"

#include <cstdarg>
#include <cstdio>

namespace whittle::text {

std::string format(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string out(length < 0 ? 0 : static_cast<std::size_t>(length) + 1, '\0');
  std::vsnprintf(out.data(), out.size(), format, again);
  va_end(again);
  if (!out.empty()) out.pop_back();  // the terminating zero
  return out;
}

}  // namespace whittle::text
