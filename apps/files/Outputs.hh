/// \file
/// All files that a run writes: they appear together, or none does.
#pragma once

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "files/MeshFile.hh"
#include "files/Target.hh"
#include "files/TemporaryFile.hh"

namespace whittle::files {

/// Told of every input and output before anything is done, it refuses outputs that lead to one file, or to a
/// file that is read; links, letters' case and standard output that is a file included. Outputs are then
/// written beside their targets, and take their places together. Standard output ("-"), pipes and devices are
/// written to as they are, after all files are written and before the first takes its place.
class Outputs {
 public:
  /// An input, by the name that messages give it: "IN".
  void reads(const std::string& role, const std::filesystem::path& path);

  /// Files that an input names, known once it is read: its libraries, images and data.
  /// \throw FileError  an output leads to one of them
  void reads_beside(const std::string& role, const std::set<std::filesystem::path>& files);

  /// An output, "--json"; an empty path is none.
  /// \param in_place_of  the input that this output may replace
  /// \throw FileError  it cannot be written, or leads to the same file as another output or an input
  void add(const std::string& role, const std::filesystem::path& path, const std::string& in_place_of = {});

  /// Whether there is an output of this role.
  bool has(const std::string& role) const;

  /// What goes there; nothing where there is no output of this role.
  /// \throw FileError  disk full, …: nothing will appear
  void write(const std::string& role, std::string bytes);

  /// Files that belong beside an output, which the caller has not named. They replace nothing: one that is there already
  /// must be the same. They take their places before the outputs that name them.
  /// \throw FileError  another file of its name is there
  void write_beside(std::vector<Companion> companions);

  /// Makes all appear that has been written. Then what an old result had beside it for itself alone goes, where the new
  /// one does not name it (own_companions).
  /// \throw FileError  nothing has appeared, except on streams, and where the file system cannot exchange files
  ///                   what took its place before the failure
  void commit();

 private:
  struct Path {
    std::string role;
    std::filesystem::path path;
    Identity identity;
  };
  struct Stream {
    std::filesystem::path path;
    Target target;
    std::string bytes;
  };
  struct File {
    File(const std::filesystem::path& named, const Target& target, const std::string& bytes)
        : path(named), folder(folder_of(target.path)), file(target, bytes) {}
    std::filesystem::path path, folder;
    TemporaryFile file;
  };
  const Path* find(const std::string& role) const;
  bool replaces_input() const;
  void put_files();

  std::vector<Path> inputs_, outputs_;
  std::list<Stream> streams_;
  std::list<File> files_;
};

}  // namespace whittle::files
