/// \file
/// What a batch works on.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace whittle::batch {

/// A folder or a manifest that cannot be used. `what()` is one line.
class BatchError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Item {
  std::filesystem::path in, out;
  std::string name;  ///< unique in the batch, and valid as a part of a file's name
};

struct Listing {
  std::vector<Item> items;
  std::vector<std::string> problems;  ///< folders that could not be listed, and why; a line each
};

/// Whether names that differ in case only are different files in a folder, or in the one that it is to be made in. Finds
/// out by a folder that is gone again; true where none can be made.
bool case_counts_in(std::filesystem::path folder);

/// All meshes of a folder and of those in it, by name; or of a manifest: a file's name on each line, relative
/// to the manifest's folder, empty lines and those that begin with # left out.
/// \param out     a folder; meshes that lie in it already are no input, unless it is the source itself.
/// \param format  the extension of the results; empty: that of the input.
/// \param case_counts  asked about `out` if there are results whose names differ in case only.
/// \throw BatchError  neither folder nor file; two results would have one name, or the place of an input that
///                    is not their own; a line that is no file name.
Listing list_items(const std::filesystem::path& source, const std::filesystem::path& out,
                   const std::string& format, bool (*case_counts)(std::filesystem::path) = case_counts_in);

}  // namespace whittle::batch
