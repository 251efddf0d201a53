/// \file
/// Lines of words as a shell reads and writes them.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace whittle::viewer {

/// A quote that is not closed.
class WordsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Splits at blanks and line ends; '…' and "…" hold words together, a backslash takes the next character as
/// it is, and one at the end of a line joins it with the next. `#` begins a comment where a word would begin.
/// \throw WordsError
std::vector<std::string> split_words(const std::string& text);

/// The word as a POSIX shell must be given it.
std::string quote(const std::string& word);

}  // namespace whittle::viewer
