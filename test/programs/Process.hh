/// \file
/// Runs a program as a user would and takes what it prints.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "Folder.hh"

namespace programs {

/// The same with paths as arguments take them.
struct Folder : scratch::Folder {
  std::string operator/(const std::string& name) const { return (path() / name).string(); }
};

using scratch::contents;

struct Outcome {
  int code = -1;
  std::string out, err;

  std::size_t error_lines() const {
    return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n'));
  }
};

inline Outcome run(const std::string& program, const std::vector<std::string>& arguments) {
  const Folder folder;
  std::string command = "'" + program + "'";
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  command += " >'" + folder / "out" + "' 2>'" + folder / "err" + "' </dev/null";
  const int status = std::system(command.c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), contents(folder / "out"), contents(folder / "err")};
}

}  // namespace programs
