/// \file
/// Files that appear whole or not at all.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "files/Descriptor.hh"
#include "files/Fault.hh"
#include "files/MeshFile.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_errno() {
  throw Fault(error_text(errno));
}

/// Where the bytes go.
struct Target {
  fs::path path;        ///< with symbolic links followed, unless it is a stream
  bool stream = false;  ///< a device or a pipe: written to, never replaced
  bool exists = false;
  mode_t permissions = 0;  ///< of what exists
};

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void require_access(const fs::path& path, int mode) {
  if (::faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) != 0) throw_errno();
}

/// Follows links by hand, because the last one may lead to a file that is still to be made.
/// \return empty if the way goes through /proc, as /dev/stdout does: what is open there must not be replaced
fs::path follow_links(fs::path path) {
  constexpr int most_links = 40;  // as the kernel
  std::error_code error;
  for (int i = 0; i < most_links; ++i) {
    const fs::path link = fs::read_symlink(path, error);
    if (error) return path;
    if (path.string().rfind("/proc/", 0) == 0) return {};
    path = folder_of(path) / link;
  }
  errno = ELOOP;
  throw_errno();
}

Target find_target(const fs::path& path) {
  if (path.empty()) throw Fault(error_text(ENOENT));
  Target target;
  struct stat status {};
  target.exists = ::stat(path.c_str(), &status) == 0;
  if (!target.exists && errno != ENOENT) throw_errno();
  if (target.exists && S_ISDIR(status.st_mode)) throw Fault(error_text(EISDIR));
  if (target.exists) require_access(path, W_OK);
  target.permissions = status.st_mode & 07777;

  target.path = follow_links(path);
  target.stream = target.path.empty() || (target.exists && !S_ISREG(status.st_mode));
  if (target.stream)
    target.path = path;
  else
    require_access(folder_of(target.path), W_OK | X_OK);
  return target;
}

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) throw_errno();
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

void write_stream(const fs::path& path, const std::string& bytes) {
  // Appending matters where standard output is a file that others write to as well.
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (file.get() < 0) throw_errno();
  write_all(file.get(), bytes);
  if (file.close() != 0) throw_errno();
}

/// A new file in a folder that is gone again unless it gets its place. Where the file system can, it has no
/// name until it is whole, so that not even a killed process leaves it behind.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& folder) : folder_(folder), file_(create()) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  int descriptor() const { return file_.get(); }

  void flush() {
    if (::fsync(file_.get()) != 0) throw_errno();
  }

  void move_to(const fs::path& target) {
    if (path_.empty() && name_it(target)) return close();
    // Only a name can be moved over the old file.
    for (int i = 0; path_.empty(); ++i) {
      const fs::path candidate = free_name(i);
      if (name_it(candidate)) path_ = candidate;
    }
    close();
    if (std::rename(path_.c_str(), target.c_str()) != 0) throw_errno();
    path_.clear();
  }

 private:
  int create() {
    // Through /proc it gets its name later.
    if (::access("/proc/self/fd", X_OK) == 0) {
      const int file = ::open(folder_.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
      if (file >= 0) return file;
    }
    for (int i = 0;; ++i) {
      path_ = free_name(i);
      const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file >= 0) return file;
      if (errno == EEXIST) continue;
      path_.clear();
      throw_errno();
    }
  }

  /// The name does not grow with the target's, which may be as long as names can be.
  fs::path free_name(int number) const {
    return folder_ / (".whittle-" + std::to_string(::getpid()) + "-" + std::to_string(number) + ".tmp");
  }

  /// False if there is a file of this name.
  bool name_it(const fs::path& path) {
    const std::string opened = "/proc/self/fd/" + std::to_string(file_.get());
    if (::linkat(AT_FDCWD, opened.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
    if (errno != EEXIST) throw_errno();
    return false;
  }

  void close() {
    if (file_.close() != 0) throw_errno();
  }

  fs::path folder_;
  fs::path path_;  ///< empty: it has no name
  Descriptor file_;
};

/// Makes the rename last through a power cut. A folder that cannot be opened for reading, or a file system
/// that knows no such thing, is no failure: the file is complete.
void flush_folder(const fs::path& folder) {
  const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.get() >= 0 && ::fsync(file.get()) != 0 && errno == EIO) throw_errno();
}

void replace(const Target& target, const std::string& bytes) {
  const fs::path folder = folder_of(target.path);
  TemporaryFile file(folder);
  // Before the bytes are in it: a private file must not be open to all for a moment.
  if (target.exists && ::fchmod(file.descriptor(), target.permissions) != 0) throw_errno();
  write_all(file.descriptor(), bytes);
  file.flush();
  file.move_to(target.path);
  flush_folder(folder);
}

}  // namespace

void check_creatable(const fs::path& path) {
  naming(path, [&] { find_target(path); });
}

void write_file(const fs::path& path, const std::string& bytes) {
  naming(path, [&] {
    const Target target = find_target(path);
    if (target.stream)
      write_stream(target.path, bytes);
    else
      replace(target, bytes);
  });
}

}  // namespace whittle::files
