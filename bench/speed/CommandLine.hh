/// \file
/// The command line's options.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "speed/rounds.hh"

namespace whittle::speed {

/// A command line that means nothing; `what()` is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CommandLine {
  std::vector<std::filesystem::path> models;  ///< none: those in the cache of assets
  std::vector<Suite> suites = {Suite::figures};
  std::optional<std::size_t> rounds;   ///< none: the suite's
  std::optional<std::size_t> samples;  ///< none: the suite's
  std::size_t subdivisions = 2;        ///< of the last model of the growth suite
  std::optional<std::string> only_text;
  std::optional<std::regex> only;
  std::optional<unsigned> threads;  ///< none: all that the process may use
  std::filesystem::path out = "results";
  std::string name = "speed";                      ///< of the two files
  std::vector<std::filesystem::path> report;       ///< runs to report on, instead of a run
  bool shapes = false;                             ///< the table of shapes instead of suites
  bool textured = false;                           ///< the suite of textured models instead of suites
  std::optional<std::filesystem::path> compare;    ///< textured: what other programs have made
  std::optional<std::filesystem::path> export_to;  ///< textured: no run, the models as files for them
  bool quiet = false;
  std::string answer;  ///< the text of --help or --version: print it and be done

  Settings settings(Suite suite) const {
    return {suite, rounds.value_or(suite == Suite::figures ? 7 : 3), only,
            samples.value_or(Settings().samples)};
  }
};

/// \throw UsageError
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace whittle::speed
