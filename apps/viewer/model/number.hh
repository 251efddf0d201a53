/// \file
/// Numbers for people: as text, short and without rounding surprises.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace whittle::viewer {

/// The shortest text that reads back the same number.
std::string to_text(double value);

/// The number rounded to so many significant digits.
double rounded(double value, int digits);

/// A finite number and nothing else.
std::optional<double> to_number(const std::string& text);

/// `12,345`: with a comma every three digits.
std::string grouped(std::size_t count);

/// Four significant digits: `0.001234`, `1.2e-05`.
std::string figure(double value);

}  // namespace whittle::viewer
