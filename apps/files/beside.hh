/// \file
/// Files that a mesh's file names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace whittle::files {

/// Where a file is that another one names: in the folder of that or below, links resolved. None for an empty name, an
/// absolute one, one that leads out of the folder, or where `file` is standard input. It need not exist.
std::optional<std::filesystem::path> beside(const std::filesystem::path& file, const std::string& name);

/// Where a file leads that names another one.
struct Link {
  std::filesystem::path path = {};  ///< empty: it is refused
  bool is_there = false;            ///< a regular file
  bool is_inside = false;           ///< of the folder of the file that names it, or below
  std::string refusal = {};         ///< "'/a/b.mtl', an absolute path"
};

/// As OBJ files and their libraries name others: by a relative path, which may lead out of the folder, with slashes or
/// with backslashes. An absolute path, a URL, and any name in a file from standard input are refused.
Link follow(const std::filesystem::path& file, const std::string& name);

/// The same for glTF, whose names may not lead out of its folder.
Link follow_beside(const std::filesystem::path& file, const std::string& name);

/// Whether a name begins like a URL: letters before a colon, but not one alone, which is a drive.
bool is_url(std::string_view name);

/// The bytes of a regular file, at most so many; none where it cannot be read or is longer.
std::optional<std::string> bytes_of(const std::filesystem::path& path, std::size_t most);

/// A path as a file in a folder names it.
/// \param folder  of the file that names it; empty: the current one
std::string relative_name(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace whittle::files
