#include "files/TemporaryFile.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "files/Fault.hh"

namespace whittle::files {

namespace fs = std::filesystem;

void keep_owner(int file, const struct stat& old) {
  struct stat now {};
  if (::fstat(file, &now) != 0) throw_errno();
  // The group alone is often allowed where the owner is not. What is not allowed stays as it is.
  if (now.st_gid != old.st_gid) [[maybe_unused]]
    const int kept = ::fchown(file, static_cast<uid_t>(-1), old.st_gid);
  if (now.st_uid != old.st_uid) [[maybe_unused]]
    const int kept = ::fchown(file, old.st_uid, static_cast<gid_t>(-1));
  if (::fchmod(file, old.st_mode & 07777) != 0) throw_errno();  // last, as a new owner takes bits away
}

TemporaryFile::TemporaryFile(const Target& target, const std::string& bytes)
    : target_(target.path), folder_(folder_of(target.path)), file_(create()) {
  try {
    // Before the bytes are in it: a private file must not be open to all for a moment.
    if (target.exists) keep_owner(file_.get(), target.old);
    write_all(file_.get(), bytes);
    if (::fsync(file_.get()) != 0) throw_errno();
  } catch (...) {
    if (!path_.empty()) ::unlink(path_.c_str());
    throw;
  }
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

int TemporaryFile::create() {
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
fs::path TemporaryFile::free_name(int number) const {
  return folder_ / (".whittle-" + std::to_string(::getpid()) + "-" + std::to_string(number) + ".tmp");
}

/// False if there is a file of this name.
bool TemporaryFile::link_to(const fs::path& path) {
  const std::string opened = "/proc/self/fd/" + std::to_string(file_.get());
  if (::linkat(AT_FDCWD, opened.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
  if (errno != EEXIST) throw_errno();
  return false;
}

void TemporaryFile::close() {
  if (file_.get() >= 0 && file_.close() != 0) throw_errno();
}

void TemporaryFile::name() {
  for (int i = 0; path_.empty(); ++i) {
    const fs::path candidate = free_name(i);
    if (link_to(candidate)) path_ = candidate;
  }
  close();
}

void TemporaryFile::put() {
  if (path_.empty() && link_to(target_)) return close();
  name();  // only a name can be moved over the old file
  if (std::rename(path_.c_str(), target_.c_str()) != 0) throw_errno();
  path_.clear();
}

void TemporaryFile::try_put() {
  if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
    put_ = Put::exchanged;  // the old file has the temporary name now
    return;
  }
  const bool is_new = ::access(target_.c_str(), F_OK) != 0;
  if (std::rename(path_.c_str(), target_.c_str()) != 0) throw_errno();
  path_.clear();
  if (is_new) put_ = Put::made;
}

void TemporaryFile::take_back() noexcept {
  if (put_ == Put::exchanged)
    ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE);
  if (put_ == Put::made) ::unlink(target_.c_str());
  put_ = Put::no;
}

void flush_folder(const fs::path& folder) {
  const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.get() >= 0 && ::fsync(file.get()) != 0 && errno == EIO) throw_errno();
}

}  // namespace whittle::files
