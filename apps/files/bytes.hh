/// \file
/// Numbers in binary files, byte by byte, so that neither the host's byte order nor alignment matters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace whittle::files {

enum class ByteOrder { little, big };

/// The unsigned integer as wide as T.
template <typename T>
using BitsOf =
    std::conditional_t<sizeof(T) == 1, std::uint8_t,
                       std::conditional_t<sizeof(T) == 2, std::uint16_t,
                                          std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

template <typename T>
T load(const char* from, ByteOrder order) {
  BitsOf<T> bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t shift = 8 * (order == ByteOrder::little ? i : sizeof(T) - 1 - i);
    bits =
        static_cast<BitsOf<T>>(bits | static_cast<BitsOf<T>>(static_cast<unsigned char>(from[i])) << shift);
  }
  T value;
  std::memcpy(&value, &bits, sizeof(T));
  return value;
}

template <typename T>
void append_little(std::string& to, T value) {
  BitsOf<T> bits;
  std::memcpy(&bits, &value, sizeof(T));
  char bytes[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = static_cast<char>(bits >> (8 * i) & 0xff);
  to.append(bytes, sizeof(T));
}

}  // namespace whittle::files
