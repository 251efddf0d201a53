#include "files/gltf_uri.hh"

#include <cctype>
#include <cstddef>

#include "files/Fault.hh"
#include "files/base64.hh"
#include "files/beside.hh"

namespace whittle::files {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

std::string decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  constexpr std::string_view base64 = ";base64";
  if (!is_data_uri(uri) || comma == std::string_view::npos || comma < base64.size() ||
      uri.substr(comma - base64.size(), base64.size()) != base64)
    throw Fault("its data are not in base64");
  return decode_base64(uri.substr(comma + 1));
}

std::string decode_percents(std::string_view uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
    if (low >= 0) i += 2;
    name += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
  }
  return name;
}

std::string encode_percents(std::string_view name) {
  constexpr std::string_view digits = "0123456789ABCDEF", plain = "-_.~/()!,+@&=$";
  std::string uri;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0 || plain.find(c) != std::string_view::npos)
      uri += c;
    else
      (((uri += '%') += digits[byte >> 4]) += digits[byte & 15U]);
  }
  return uri;
}

std::string read_beside(const std::filesystem::path& path, std::string_view uri) {
  if (path == "-")
    throw Fault("its data are in the file " + in_quotes(uri) +
                ", which standard input does not have beside it");
  const std::string name = decode_percents(uri);
  const Link link = follow_beside(path, name);
  if (!link.refusal.empty())
    throw Fault("its data are refused: " + link.refusal + "; only files in its folder are read");
  auto bytes = bytes_of(link.path, static_cast<std::size_t>(-1) / 4);
  if (!bytes) throw Fault("its data cannot be read: " + in_quotes(name) + " is missing or not a file");
  return std::move(*bytes);
}

}  // namespace whittle::files
