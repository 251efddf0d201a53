/// \file
/// A field for a path, and the files that it could mean.
#pragma once

#include <string>
#include <vector>

#include "panels/Ui.hh"

namespace whittle::viewer {

/// Edits `ui.path`. Below stand the folders and the files with one of the extensions in the folder of the
/// path, which begin with what is typed.
/// \return whether Enter was pressed, or a file double-clicked.
bool file_field(Ui& ui, const std::vector<std::string>& extensions);

/// The entries that complete a path: folders with a slash at their end, then files; sorted.
std::vector<std::string> completions(const std::string& path, const std::vector<std::string>& extensions);

}  // namespace whittle::viewer
