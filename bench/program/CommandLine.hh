/// \file
/// What the user asked for.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "egl/EglContext.hh"
#include "experiment/Experiment.hh"

namespace whittle::bench {

/// A command line that means nothing; `what()` is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CommandLine {
  std::optional<std::filesystem::path> model;
  std::string label;
  Settings settings;
  egl::DeviceChoice device;
  std::filesystem::path out = "results";
  std::vector<SetDefinition> sets;
  bool pictures_only = false;
  bool list_devices = false;
  bool quiet = false;
  std::string answer;  ///< the text of --help or --version: print it and be done
};

/// \throw UsageError
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace whittle::bench
