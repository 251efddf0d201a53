/// \file
/// results.json of a run that may be cut off at any moment.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>

#include "results/Results.hh"

namespace whittle::bench {

/// Results could not be written; `what()` is one line: why, and what is kept.
class SaveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Store {
 public:
  /// \param folder  made if missing.
  /// \throw std::filesystem::filesystem_error, files::FileError  nothing can be written there.
  explicit Store(const std::filesystem::path& folder);

  /// The results of an earlier start, for --resume; none where there are no results.
  /// \throw ResultsError, files::FileError  they cannot be read.
  std::optional<Results> load() const;

  /// Renames the results of another run to results.1.json (or 2, 3, …), so that nothing is lost.
  /// \return the new name, if there were any.
  std::optional<std::filesystem::path> set_aside() const;

  /// Replaces results.json in one step: whenever the program is killed, the file is whole.
  /// \throw SaveError
  void save(const Results& results) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path path() const { return folder_ / "results.json"; }
  std::filesystem::path folder_;
};

/// Reads a whole file.
/// \throw std::runtime_error  one line.
std::string read_text(const std::filesystem::path& path);

/// Why `earlier` cannot be gone on with as `wanted`, or an empty text: other protocol, model, sets, image
/// size or renderer.
std::string difference(const Results& earlier, const Results& wanted);

}  // namespace whittle::bench
