/// \file
/// The values of a PLY file, one after the other, from text or from bytes. Both readers have the same
/// members.
#pragma once

#include <cstdint>
#include <string_view>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/bytes.hh"
#include "files/ply_header.hh"

namespace whittle::files {

/// Text: one line for each thing of an element.
class PlyText {
 public:
  explicit PlyText(TextReader& in) : in_(in) {}

  static std::size_t least_bytes(PlyType) { return 2; }  // a digit and a blank
  std::size_t remaining() const { return in_.remaining(); }

  void begin_line() {
    if (!in_.next_line()) throw Fault("the file is cut off");
  }
  /// \return whether there was more in it than the header declares
  bool end_line() { return !in_.word().empty(); }

  double real(PlyType type) { return type == PlyType::float32 ? in_.real<float>() : in_.real<double>(); }
  std::int64_t integer(PlyType) { return in_.integer(); }
  void skip(PlyType, std::uint64_t values) {
    for (std::uint64_t i = 0; i < values; ++i) in_.real<double>();
  }

 private:
  TextReader& in_;
};

/// Bytes of either order, without anything between.
class PlyBytes {
 public:
  PlyBytes(std::string_view bytes, ByteOrder order) : bytes_(bytes), order_(order) {}

  static std::size_t least_bytes(PlyType type) { return ply_size(type); }
  std::size_t remaining() const { return bytes_.size(); }

  void begin_line() {}
  bool end_line() { return false; }

  double real(PlyType type) {
    switch (type) {
      case PlyType::float32:
        return next<float>();
      case PlyType::float64:
        return next<double>();
      default:
        return static_cast<double>(integer(type));
    }
  }

  /// \pre type is one of the integers
  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return next<std::int8_t>();
      case PlyType::uint8:
        return next<std::uint8_t>();
      case PlyType::int16:
        return next<std::int16_t>();
      case PlyType::uint16:
        return next<std::uint16_t>();
      case PlyType::int32:
        return next<std::int32_t>();
      default:
        return next<std::uint32_t>();
    }
  }

  void skip(PlyType type, std::uint64_t values) {
    if (values > bytes_.size() / ply_size(type)) throw Fault("the file is cut off");
    bytes_.remove_prefix(values * ply_size(type));
  }

 private:
  template <typename T>
  T next() {
    if (bytes_.size() < sizeof(T)) throw Fault("the file is cut off");
    const T value = load<T>(bytes_.data(), order_);
    bytes_.remove_prefix(sizeof(T));
    return value;
  }

  std::string_view bytes_;
  ByteOrder order_;
};

}  // namespace whittle::files
