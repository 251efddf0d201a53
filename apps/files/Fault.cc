#include "files/Fault.hh"

#include <cctype>
#include <cerrno>

#include "files/Descriptor.hh"

namespace whittle::files {

void throw_errno() {
  throw Fault(error_text(errno));
}

std::string display_name(const std::filesystem::path& path) {
  return path == "-" ? "standard output" : path.string();
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, longest))
    result += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

}  // namespace whittle::files
