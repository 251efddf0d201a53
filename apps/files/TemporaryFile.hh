/// \file
/// A file beside its target until it takes the target's place.
#pragma once

#include <filesystem>
#include <string>

#include "files/Descriptor.hh"
#include "files/Target.hh"

namespace whittle::files {

/// Written in the folder of its target, and gone again unless it gets its place. Where the file system can, it
/// has no name until it is whole, so that not even a killed process leaves it behind. All throw Fault.
class TemporaryFile {
 public:
  /// The bytes are on the disk afterwards. What an old file has beside its bytes is kept, as `keep_attributes`
  /// does.
  TemporaryFile(const Target& target, const std::string& bytes);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Takes the place of the target.
  void put();

  /// The same, but so that it can be taken back: name() first, so that room is not what is lacking later.
  /// \{
  void name();
  void try_put();
  void take_back() noexcept;  ///< what was there is there again, where the file system can exchange files
                              /// \}

 private:
  int create();
  std::filesystem::path free_name(int number) const;
  bool link_to(const std::filesystem::path& path);
  void close();

  enum class Put { no, made, exchanged };
  std::filesystem::path target_, folder_;
  std::filesystem::path path_;  ///< empty: it has no name, or that of the target
  Put put_ = Put::no;
  Descriptor file_;
};

/// Makes names in a folder last through a power cut. A folder that cannot be opened for reading, or a file
/// system that knows no such thing, is no failure: the files are complete.
void flush_folder(const std::filesystem::path& folder);

/// Gives a file the permissions of the old one and, where that is allowed, its owner, group, access control list and
/// extended attributes.
void keep_attributes(int file, const Target& target);

}  // namespace whittle::files
