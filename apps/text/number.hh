/// \file
/// Numbers as text.
#pragma once

#include <cstddef>
#include <string>

namespace whittle::text {

/// The shortest text that reads back the same number.
std::string shortest(double value);

/// Rounded to so many significant digits, without trailing zeros: `0.001234`, `1.2e-05`.
std::string significant(double value, int digits);

/// With a comma every three digits: `12,345`.
/// \param whole  digits, perhaps with a minus sign before them.
/// \{
std::string grouped(std::string whole);
std::string grouped(std::size_t count);
/// \}

}  // namespace whittle::text
