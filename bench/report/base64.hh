/// \file
/// Bytes as text, for pictures inside of a page.
#pragma once

#include <string>

namespace whittle::bench {

/// RFC 4648, with padding, without line breaks.
std::string base64(const std::string& bytes);

}  // namespace whittle::bench
