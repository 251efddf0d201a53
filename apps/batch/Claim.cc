#include "batch/Claim.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace whittle::batch {
namespace {

namespace fs = std::filesystem;

bool create(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    if (errno == EEXIST) return false;
    throw fs::filesystem_error("cannot claim", file, std::error_code(errno, std::generic_category()));
  }
  const std::string owner = process_name() + "\n";
  [[maybe_unused]] const ssize_t written = write(descriptor, owner.data(), owner.size());  // for people only
  close(descriptor);
  return true;
}

/// By the clock of the file system, which all who share the folder see alike.
bool is_stale(const fs::path& file, std::chrono::seconds life) {
  const fs::path clock = file.string() + "." + process_name() + ".clock";
  const int descriptor = open(clock.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  struct stat now {};
  struct stat then {};
  const bool both =
      futimens(descriptor, nullptr) == 0 && fstat(descriptor, &now) == 0 && stat(file.c_str(), &then) == 0;
  close(descriptor);
  unlink(clock.c_str());
  return both && now.st_mtime - then.st_mtime > life.count();
}

}  // namespace

std::string process_name() {
  char host[256] = "localhost";
  gethostname(host, sizeof host - 1);
  return std::string(host) + "-" + std::to_string(getpid());
}

std::optional<Claim> Claim::take(const fs::path& file, std::chrono::seconds life) {
  if (create(file)) return Claim(file);
  if (!is_stale(file, life)) return std::nullopt;
  // Of all who move it away only one finds it there.
  const fs::path aside = file.string() + "." + process_name() + ".stale";
  if (std::rename(file.c_str(), aside.c_str()) != 0) return std::nullopt;
  // Another process may have taken it over meanwhile, so that it is a fresh claim: then it is restored.
  if (!is_stale(aside, life)) {
    [[maybe_unused]] const int linked = link(aside.c_str(), file.c_str());
    unlink(aside.c_str());
    return std::nullopt;
  }
  unlink(aside.c_str());
  if (create(file)) return Claim(file);
  return std::nullopt;
}

Claim::Claim(Claim&& other) noexcept : file_(std::exchange(other.file_, {})) {}

Claim::~Claim() {
  if (!file_.empty()) unlink(file_.c_str());
}

void Claim::touch() const {
  utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
}

}  // namespace whittle::batch
