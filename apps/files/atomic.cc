/// \file
/// Files that appear whole or not at all.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "files/Descriptor.hh"
#include "files/Fault.hh"
#include "files/MeshFile.hh"
#include "files/Target.hh"
#include "files/TemporaryFile.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

/// False where they are on two file systems.
bool rename_over(const fs::path& from, const Target& target) {
  Descriptor file(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) throw_errno();
  if (target.exists) keep_attributes(file.get(), target);
  if (std::rename(from.c_str(), target.path.c_str()) != 0) {
    if (errno == EXDEV) return false;
    throw_errno();
  }
  flush_folder(folder_of(target.path));
  return true;
}

}  // namespace

void check_creatable(const fs::path& path) {
  naming(path, [&] { find_target(path); });
}

void write_file(const fs::path& path, const std::string& bytes) {
  naming(path, [&] {
    const Target target = find_target(path);
    if (target.stream) return write_stream(target, bytes);
    TemporaryFile file(target, bytes);
    file.put();
    flush_folder(folder_of(target.path));
  });
}

void move_file(const fs::path& from, const fs::path& to) {
  const bool moved = naming(to, [&] {
    const Target target = find_target(to);
    return !target.stream && rename_over(from, target);
  });
  if (moved) return;
  write_file(to, read_file(from));
  std::error_code ignored;
  fs::remove(from, ignored);
}

}  // namespace whittle::files
