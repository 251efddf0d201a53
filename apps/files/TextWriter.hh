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
  /// \param single_precision  the digits of a coordinate need only name the nearest float
  explicit TextWriter(bool single_precision) : single_precision_(single_precision) {}

  TextWriter& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  TextWriter& operator<<(std::uint64_t count) { return number(count); }
  TextWriter& operator<<(float value) { return number(value); }

  /// With a decimal point or an exponent, also where the value is whole.
  TextWriter& with_point(float value) {
    const std::size_t begin = text_.size();
    number(value);
    return text_.find_first_of(".e", begin) == std::string::npos ? *this << ".0" : *this;
  }

  /// Three coordinates with blanks between them.
  TextWriter& operator<<(const IndexedMesh::Point& point) {
    coordinate(point.x()) << " ";
    coordinate(point.y()) << " ";
    return coordinate(point.z());
  }

  /// Some floats, each with a blank before it.
  TextWriter& floats(const float* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) *this << " " << values[i];
    return *this;
  }

  TextWriter& coordinate(double value) {
    return single_precision_ ? number(static_cast<float>(value)) : number(value);
  }

  std::string take() { return std::move(text_); }

 private:
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
