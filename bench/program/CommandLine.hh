/// \file
/// The command line's options.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "egl/EglContext.hh"
#include "experiment/Protocol.hh"

namespace whittle::bench {

/// A command line that means nothing; `what()` is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ImageSize {
  int width, height;
};

struct CommandLine {
  std::optional<std::filesystem::path> model, monkey;
  std::string label;
  egl::DeviceChoice device;
  std::filesystem::path out = "results";
  std::vector<std::string> experiments;  ///< names, in kExperiments' order
  std::vector<SetDefinition> sets;       ///< of Paper 1

  /// Without --quick or --paper the renderer decides. \{
  bool quick = false, paper = false;
  /// \}
  /// In place of the protocol's. \{
  std::optional<ImageSize> size;
  std::optional<std::size_t> repetitions, frames_from, frames_to, views, samples;
  /// \}

  bool resume = false, pictures_only = false, list_devices = false, quiet = false;
  std::optional<std::filesystem::path> report;  ///< results.json to make the report of; nothing is drawn
  std::string answer;                           ///< to --help and --version; then nothing else counts

  /// The protocol with the options applied; its name tells whether something was changed.
  /// \param software  the renderer is a program.
  /// \throw UsageError  frames that end before they begin
  Protocol protocol(bool software) const;
};

/// \throw UsageError
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace whittle::bench
