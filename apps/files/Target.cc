#include "files/Target.hh"

#include <fcntl.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <iostream>

#include "files/Descriptor.hh"
#include "files/Fault.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

void require_access(const fs::path& path, int mode) {
  if (::faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) != 0) throw_errno();
}

/// In a folder such as /tmp only the owner of a file may replace it, whatever its permissions are.
void require_replaceable(const fs::path& folder, const struct stat& file) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) throw_errno();
  const uid_t user = ::geteuid();
  if ((status.st_mode & S_ISVTX) == 0 || user == 0 || user == status.st_uid || user == file.st_uid) return;
  errno = EPERM;
  throw_errno();
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

std::string in_lower_case(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

}  // namespace

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

Target find_target(const fs::path& path) {
  if (path.empty()) throw Fault(error_text(ENOENT));
  Target target;
  if (path == "-") {
    target.path = path;
    target.stream = target.exists = true;
    if (::fstat(STDOUT_FILENO, &target.old) != 0) throw_errno();
    return target;
  }
  target.exists = ::stat(path.c_str(), &target.old) == 0;
  if (!target.exists && errno != ENOENT) throw_errno();
  if (target.exists && S_ISDIR(target.old.st_mode)) throw Fault(error_text(EISDIR));
  if (target.exists) require_access(path, W_OK);

  target.path = follow_links(path);
  target.stream = target.path.empty() || (target.exists && !S_ISREG(target.old.st_mode));
  if (target.stream) {
    target.path = path;
    return target;
  }
  const fs::path folder = folder_of(target.path);
  std::error_code error;
  if (!fs::exists(folder, error) && !error) throw Fault("its folder does not exist; make it first");
  require_access(folder, W_OK | X_OK);
  if (target.exists) require_replaceable(folder_of(target.path), target.old);
  return target;
}

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) throw_errno();
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

void write_stream(const Target& target, const std::string& bytes) {
  if (target.path == "-") {
    // What was printed before comes first.
    std::cout.flush();
    std::fflush(stdout);
    return write_all(STDOUT_FILENO, bytes);
  }
  // Appending matters where standard output is a file that others write to as well.
  Descriptor file(::open(target.path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (file.get() < 0) throw_errno();
  write_all(file.get(), bytes);
  if (file.close() != 0) throw_errno();
}

Identity identity_of(const fs::path& path, int stream) {
  struct stat status {};
  const bool exists = path == "-" ? ::fstat(stream, &status) == 0 : ::stat(path.c_str(), &status) == 0;
  if (exists)
    return {status.st_dev,
            status.st_ino,
            {},
            S_ISREG(status.st_mode) || S_ISBLK(status.st_mode),
            S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 3)};
  if (path.empty() || path == "-" || errno != ENOENT) return {};
  const fs::path target = follow_links(path);
  if (target.empty() || ::stat(folder_of(target).c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino, in_lower_case(target.filename().string()), true, false};
}

}  // namespace whittle::files
