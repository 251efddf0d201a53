/// \file
/// Files that a mesh's file names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace whittle::files {

/// Where a file is that another one names: in the folder of that or below, links resolved. None for an empty name, an
/// absolute one, one that leads out of the folder, or where `file` is standard input. It need not exist.
std::optional<std::filesystem::path> beside(const std::filesystem::path& file, const std::string& name);

/// The bytes of a regular file, at most so many; none where it cannot be read or is longer.
std::optional<std::string> bytes_of(const std::filesystem::path& path, std::size_t most);

/// A path as a file in a folder names it.
/// \param folder  of the file that names it; empty: the current one
std::string relative_name(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace whittle::files
