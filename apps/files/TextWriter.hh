/// \file
/// Numbers to text, shortest first: as few digits as read back the same bits.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "files/MeshFile.hh"

namespace whittle::files {

class TextWriter {
 public:
  /// \param single_precision  the digits need only name the nearest float
  explicit TextWriter(bool single_precision) : single_precision_(single_precision) {}

  TextWriter& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  TextWriter& operator<<(std::uint64_t count) { return number(count); }

  /// Three coordinates with blanks between them.
  TextWriter& operator<<(const IndexedMesh::Point& point) {
    real(point.x()) << " ";
    real(point.y()) << " ";
    return real(point.z());
  }

  std::string take() { return std::move(text_); }

 private:
  TextWriter& real(double value) {
    return single_precision_ ? number(static_cast<float>(value)) : number(value);
  }

  template <typename Number>
  TextWriter& number(Number value) {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }

  bool single_precision_;
  std::string text_;
};

}  // namespace whittle::files
