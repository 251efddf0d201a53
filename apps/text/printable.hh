/// \file
/// Text of unknown origin, such as a file's name, on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace whittle::text {

/// The same on one line and harmless to a terminal: control characters, line breaks, marks that turn the
/// direction of writing and bytes that are not UTF-8 are written as `\n`, `\x1b` or `\u{202e}`.
std::string printable(std::string_view text);

}  // namespace whittle::text
