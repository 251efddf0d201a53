/// \file
/// What stands beside an old result for it alone, and goes with it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace whittle::files {

/// The buffer or the library of materials that this program has written beside a result, as that says itself: by its
/// generator, or the first line of the library. Nothing of what another program has made, of which others may be users.
/// Images stay.
std::vector<std::filesystem::path> own_companions(const std::filesystem::path& file);

/// The first line of a library: whose it is. \param obj  the file that names it
std::string library_mark(const std::filesystem::path& obj);

/// What is to go when new results have taken the place of old ones.
class OldCompanions {
 public:
  /// A result that is going to be replaced.
  void look_at(const std::filesystem::path& file);

  /// Removes what the new results do not name.
  /// \param kept  files that stay
  void remove_unnamed(const std::vector<std::filesystem::path>& kept = {}) const;

 private:
  std::vector<std::pair<std::filesystem::path, std::vector<std::filesystem::path>>> old_;
};

}  // namespace whittle::files
