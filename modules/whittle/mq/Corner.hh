/// \file
/// A corner of a triangle as a number.
#pragma once

#include <cstddef>
#include <cstdint>

namespace whittle::mq {

/// A half-edge: eight times its face plus the corner where it starts, 0..2. The same number names that
/// corner.
using Corner = std::uint32_t;
constexpr Corner kNoCorner = 0xffffffffu;

constexpr Corner corner_of(std::size_t face) {
  return static_cast<Corner>(8 * face);
}
constexpr std::uint32_t face_of(Corner c) {
  return c / 8;
}

inline Corner next(Corner c) {
  return (c & 3) == 2 ? c - 2 : c + 1;
}
inline Corner previous(Corner c) {
  return (c & 3) == 0 ? c + 2 : c - 1;
}

}  // namespace whittle::mq
