/// \file
/// What an output's path leads to.
#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <filesystem>
#include <string>

namespace whittle::files {

std::filesystem::path folder_of(const std::filesystem::path& path);

/// Where bytes go.
struct Target {
  std::filesystem::path path;  ///< with symbolic links followed, unless it is a stream; "-": standard output
  bool stream = false;         ///< a device or a pipe: written to, never replaced
  bool exists = false;
  struct stat old {};  ///< of what exists
};

/// \throw Fault  it cannot be written
Target find_target(const std::filesystem::path& path);

/// Writes all bytes to a stream. \throw Fault
void write_stream(const Target& target, const std::string& bytes);

/// \throw Fault
void write_all(int file, const std::string& bytes);

/// Which file a path leads to, whatever it is called: through links, in another case of letters, or by a
/// descriptor. A file that does not exist yet is known by its folder and its name in lower case.
struct Identity {
  dev_t device = 0;
  ino_t number = 0;
  std::string name = {};  ///< of a file that does not exist yet
  bool regular = false;   ///< a file, or one that does not exist yet
  bool sink = false;      ///< /dev/null: whatever goes there is not read again

  bool same(const Identity& other) const {
    return number != 0 && device == other.device && number == other.number && name == other.name && !sink;
  }
};

/// \param stream  which descriptor "-" means
/// \return all zero where not even the folder exists
Identity identity_of(const std::filesystem::path& path, int stream);

}  // namespace whittle::files
