/// \file
/// printf into a string.
#pragma once

#include <string>

namespace whittle::text {

/// As printf, but returned.
[[gnu::format(printf, 1, 2)]] std::string format(const char* format, ...);

}  // namespace whittle::text
