/// \file
/// Files that are written beside a result.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// A companion of this name beside a file; where another one has the name, "name-1" and so on.
/// \return the name
std::string add_companion(std::vector<Companion>& companions, const std::filesystem::path& file,
                          const std::string& name, std::string bytes);

/// A name for a companion that is made for a file and called after it: "name", or "name-1a2b3c4d", with a hash of its
/// bytes, where another file of that name is there or is to be written. So it replaces none, and an old result stays whole
/// until the new one has taken its place.
std::string own_name(const std::vector<Companion>& companions, const std::filesystem::path& file,
                     const std::string& name, const std::string& bytes);

/// Copies files beside a result, each once.
class CompanionCopier {
 public:
  /// The longest file that is copied. Bytes.
  static constexpr std::size_t kMost = std::size_t{1} << 31;

  /// \param file  the result
  CompanionCopier(const std::filesystem::path& file, std::vector<Companion>& companions)
      : file_(file), companions_(companions) {}

  /// \param only_images  whether it must begin as an image does
  /// \return the name of the copy, or of the file that is there already; empty where it cannot be read
  std::string copy(const std::filesystem::path& from, bool only_images = false);

 private:
  const std::filesystem::path& file_;
  std::vector<Companion>& companions_;
  std::map<std::filesystem::path, std::string> known_;
};

/// Whether files can be written beside one: neither standard output nor a device or pipe.
bool has_a_folder(const std::filesystem::path& file);

/// Whether both are there and one file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace whittle::files
