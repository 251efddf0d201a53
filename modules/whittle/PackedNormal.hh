/// \file
/// A unit normal in 32 bits.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace whittle {

/// Three times ten bits, good to a fifth of a degree; or no normal, that of a degenerate face.
class PackedNormal {
 public:
  PackedNormal() = default;

  /// \param normal  of unit length.
  explicit PackedNormal(const Eigen::Vector3f& normal) : bits_(1u << 31) {
    for (int i = 0; i < 3; ++i) bits_ |= static_cast<std::uint32_t>(512.5f + 511 * normal[i]) << 10 * i;
  }

  bool is_none() const { return bits_ == 0; }

  /// Of unit length but for the rounding; meaningless for none.
  Eigen::Vector3f unpacked() const {
    const auto part = [&](int i) {
      return (static_cast<float>(static_cast<int>(bits_ >> 10 * i & 1023)) - 512) * (1.0f / 511);
    };
    return {part(0), part(1), part(2)};
  }

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace whittle
