/// \file
/// Numbers.
#pragma once

namespace whittle::detail {

constexpr double kPi = 3.14159265358979323846;

}  // namespace whittle::detail
