/// \file
/// Numbers from text.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace whittle::recipe {

/// A finite number and what follows it; nothing where the text does not begin with one.
std::optional<std::pair<double, std::string>> leading_number(const std::string& text);

/// A finite number and nothing else.
std::optional<double> to_number(const std::string& text);

}  // namespace whittle::recipe
