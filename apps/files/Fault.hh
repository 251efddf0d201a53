/// \file
/// What is wrong with a file, without its name.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Thrown inside this folder only: read_mesh and write_mesh add the path and the line and throw a FileError.
class Fault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What errno says. \throw Fault
[[noreturn]] void throw_errno();

/// How messages call a path: "-" is standard output.
std::string display_name(const std::filesystem::path& path);

/// A piece of the file in quotes, shortened and printable, so that a message stays one line whatever is in
/// it.
std::string in_quotes(std::string_view text);

/// Runs an action and turns its Fault into a FileError that names the file.
template <typename Action>
auto naming(const std::filesystem::path& path, Action action) {
  try {
    return action();
  } catch (const Fault& fault) {
    throw FileError(display_name(path) + ": " + fault.what());
  }
}

}  // namespace whittle::files
