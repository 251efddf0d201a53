/// \file
/// Numbers for people: as text, short and without rounding surprises.
#pragma once

#include <string>

#include "recipe/number.hh"
#include "text/number.hh"

namespace whittle::viewer {

/// The number rounded to so many significant digits.
double rounded(double value, int digits);

using recipe::to_number;
using text::grouped;

/// Four significant digits: `0.001234`, `1.2e-05`.
std::string figure(double value);

}  // namespace whittle::viewer
