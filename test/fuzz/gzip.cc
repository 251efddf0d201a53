/// \file
/// libFuzzer's entry to what unpacks gzip: whatever the bytes are, in pieces of any size the same comes of them.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "files/Fault.hh"
#include "files/gzip.hh"

namespace {

std::string unpacked(std::string_view packed, std::size_t piece) {
  whittle::files::Gunzip gunzip;
  for (std::size_t i = 0; i < packed.size(); i += piece) gunzip.add(packed.substr(i, piece));
  return gunzip.take();
}

/// Empty where it is damaged.
std::string unpacked_or_nothing(std::string_view packed, std::size_t piece) {
  try {
    return unpacked(packed, piece);
  } catch (const whittle::files::Fault&) {
    return {};
  }
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  require(unpacked_or_nothing(bytes, 7) == unpacked_or_nothing(bytes, size + 1),
          "other bytes in other pieces");
  require(unpacked(whittle::files::gzipped(std::string(bytes)), 1000) == bytes,
          "not the same there and back");
  return 0;
}
