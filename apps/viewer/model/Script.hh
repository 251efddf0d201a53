/// \file
/// Scripts: what a user would do, one command a line.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace whittle::viewer {

/// A script that makes no sense, or a command that could not be done; `what()` is one line that names the
/// place: `tour.txt:3: unknown command 'opem'`.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Command {
  std::string name;
  std::vector<std::string> arguments;
  std::string place;  ///< `tour.txt:3`

  /// Arguments as numbers and switches.
  /// \throw ScriptError  the argument is missing or of another kind.
  /// \{
  double number(std::size_t argument) const;
  std::size_t count(std::size_t argument) const;
  bool on(std::size_t argument) const;
  /// \}
  [[noreturn]] void fail(const std::string& message) const;
};

/// \param name  of the script, for messages.
/// \throw ScriptError  an unknown command, too few or too many arguments.
std::vector<Command> parse_script(const std::string& text, const std::string& name);

/// One line for each command: its arguments and what it does.
std::string script_help();

}  // namespace whittle::viewer
