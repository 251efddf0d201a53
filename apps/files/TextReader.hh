/// \file
/// Lines and words of a text file that is already in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace whittle::files {

/// Reads the words of one line after the other. Blank lines and comments are passed over.
class TextReader {
 public:
  struct Syntax {
    char comment = '\n';        ///< starts a comment, to the end of the line; a line end stands for "none"
    bool continuation = false;  ///< a backslash at the end of a line joins it with the next
  };

  /// \param line  kept at the number of the current line, from 1
  TextReader(std::string_view bytes, std::size_t& line, Syntax syntax);

  /// Goes to the next line that has a word; false at the end of the file.
  bool next_line();

  /// The next word of the line, empty at its end.
  std::string_view word();

  /// The next word of the line or of those that follow, empty at the end of the file.
  std::string_view word_anywhere();

  /// The next word of the line as a number; a float is rounded once, from the digits.
  /// \throw Fault  there is none, or it is not a number
  /// \{
  template <typename Real>
  Real real();
  std::int64_t integer();
  std::uint64_t count();
  /// \}

  /// All that is left of the line as it stands, comments included, without the blanks at its ends; not of lines that are
  /// joined with it.
  std::string_view rest_of_line();

  /// What follows the current line.
  std::string_view rest();

  /// Bytes not read yet.
  std::size_t remaining() const { return bytes_.size() - at_; }

 private:
  void skip_blanks();
  std::size_t line_join() const;
  bool at_line_end() const;
  void leave_line();
  std::string_view required_word(const char* what);

  std::string_view bytes_;
  std::size_t& line_;
  Syntax syntax_;
  std::size_t at_ = 0;
  bool line_is_fresh_ = true;  ///< no word of the current line has been read yet
};

/// The whole word as a number. Real is float or double.
/// \throw Fault
/// \{
template <typename Real>
Real parse_real(std::string_view word);
std::int64_t parse_integer(std::string_view word);
std::uint64_t parse_count(std::string_view word);
/// \}

/// Equal but for the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

}  // namespace whittle::files
