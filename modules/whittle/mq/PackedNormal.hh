/// \file
/// A unit normal in 32 bits.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "whittle/mq/Four.hh"

namespace whittle::mq {

/// Three signed ten-bit coordinates, accurate to a fifth of a degree; or no normal, as of a degenerate face.
class PackedNormal {
 public:
  static constexpr float kLength = 511;  ///< of what it unpacks to

  PackedNormal() = default;

  /// \param normal  of unit length.
  explicit PackedNormal(const Eigen::Vector3f& normal) : bits_(1u << 31) {
    for (int i = 0; i < 3; ++i)
      bits_ |= (static_cast<std::uint32_t>(512.5f + kLength * normal[i]) ^ 512u) << 10 * i;
  }

  std::uint32_t bits() const { return bits_; }  ///< 0: no normal

  /// Four normals from their `bits`, `kLength` long up to rounding; zero where there is none.
  static FourVectors unpacked(const Eigen::Array<std::uint32_t, 4, 1>& bits) {
    const Eigen::Array4i x = bits.shiftLeft<22>().cast<int>(), y = bits.shiftLeft<12>().cast<int>(),
                         z = bits.shiftLeft<2>().cast<int>();
    return {x.shiftRight<22>().cast<float>(), y.shiftRight<22>().cast<float>(),
            z.shiftRight<22>().cast<float>()};
  }

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace whittle::mq
