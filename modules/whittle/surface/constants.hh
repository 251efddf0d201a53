/// \file
/// Numbers.
#pragma once

namespace whittle::detail {

constexpr double kPi = 3.14159265358979323846;

/// How far a vertex on a seam may rise from the surface, or sink, where one inside a chart merges into it, in lengths of
/// the edge between them.
constexpr double kSeamRise = 0.1;

}  // namespace whittle::detail
