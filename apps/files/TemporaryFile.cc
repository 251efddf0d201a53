#include "files/TemporaryFile.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <vector>

#include "files/Fault.hh"

namespace whittle::files {

namespace fs = std::filesystem;

namespace {

/// Names, each with a zero at its end.
using Names = std::vector<std::string>;

Names split(const std::vector<char>& text) {
  Names names;
  for (auto at = text.begin(); at != text.end(); ++at) {
    const auto end = std::find(at, text.end(), '\0');
    names.emplace_back(at, end);
    if (end == text.end()) break;
    at = end;
  }
  return names;
}

/// What `read(buffer, size)` returns, asked again where it has grown in between; empty where it fails.
template <typename Read>
std::vector<char> whole(Read read) {
  std::vector<char> out;
  for (int i = 0; i < 8; ++i) {
    const ssize_t size = read(nullptr, 0);
    if (size <= 0) return {};
    out.resize(static_cast<std::size_t>(size));
    const ssize_t got = read(out.data(), out.size());
    if (got < 0 && errno == ERANGE) continue;
    out.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return out;
  }
  return {};
}

/// Access control lists are extended attributes, too. What is not allowed stays as it is.
void keep_extended_attributes(int file, const fs::path& old) {
  const char* const path = old.c_str();
  const Names kept = split(whole([&](char* to, std::size_t n) { return ::listxattr(path, to, n); }));
  for (const std::string& name :
       split(whole([&](char*to, std::size_t n) { return ::flistxattr(file, to, n); })))
    if (std::find(kept.begin(), kept.end(), name) == kept.end())  // as the folder gives it to new files
      ::fremovexattr(file, name.c_str());
  for (const std::string& name : kept) {
    const std::vector<char> value =
        whole([&](char* to, std::size_t n) { return ::getxattr(path, name.c_str(), to, n); });
    ::fsetxattr(file, name.c_str(), value.data(), value.size(), 0);
  }
}

}  // namespace

void keep_attributes(int file, const Target& target) {
  const struct stat& old = target.old;
  struct stat now {};
  if (::fstat(file, &now) != 0) throw_errno();
  // The group alone is often allowed where the owner is not. What is not allowed stays as it is.
  if (now.st_gid != old.st_gid) [[maybe_unused]]
    const int kept = ::fchown(file, static_cast<uid_t>(-1), old.st_gid);
  keep_extended_attributes(file, target.path);
  if (::fchmod(file, old.st_mode & 07777) != 0) throw_errno();
  if (now.st_uid == old.st_uid) return;
  // Only its owner may change the rest, and a new owner takes bits away.
  if (::fchown(file, old.st_uid, static_cast<gid_t>(-1)) == 0 && ::fchmod(file, old.st_mode & 07777) != 0)
    throw_errno();
}

TemporaryFile::TemporaryFile(const Target& target, const std::string& bytes)
    : target_(target.path), folder_(folder_of(target.path)), file_(create()) {
  try {
    // Before the bytes are in it: a private file must not be open to all for a moment.
    if (target.exists) keep_attributes(file_.get(), target);
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
