#include "batch/Claim.hh"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <system_error>
#include <utility>

namespace whittle::batch {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_cannot_claim(const fs::path& file) {
  throw fs::filesystem_error("cannot claim", file, std::error_code(errno, std::generic_category()));
}

/// Which run of which machine's kernel this is, as locks are that kernel's; empty where it cannot be told.
const std::string& kernel_name() {
  static const std::string name = [] {
    std::string line;
    std::ifstream file("/proc/sys/kernel/random/boot_id");
    std::getline(file, line);
    return line;
  }();
  return name;
}

struct Owner {
  std::string process, kernel;
};

Owner owner_of(int file) {
  char bytes[512];
  const ssize_t length = pread(file, bytes, sizeof bytes, 0);
  const std::string text(bytes, length > 0 ? static_cast<std::size_t>(length) : 0);
  const std::size_t line = text.find('\n');
  Owner owner{text.substr(0, line), ""};
  if (line != std::string::npos) owner.kernel = text.substr(line + 1, text.find('\n', line + 1) - line - 1);
  return owner;
}

ino_t number_of(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 ? status.st_ino : 0;
}

ino_t number_of(const fs::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? status.st_ino : 0;
}

/// A name that no other process and thread uses.
fs::path own_name(const fs::path& file) {
  static std::atomic<unsigned> count{0};
  return file.parent_path() / (".claim-" + process_name() + "-" + std::to_string(++count));
}

/// Not all file systems know links.
bool name_if_free(const fs::path& file, const fs::path& name) {
  if (link(file.c_str(), name.c_str()) == 0) return true;
  return errno != EEXIST && renameat2(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), RENAME_NOREPLACE) == 0;
}

}  // namespace

std::string process_name() {
  char host[256] = "localhost";
  gethostname(host, sizeof host - 1);
  return std::string(host).substr(0, 64) + "-" + std::to_string(getpid());
}

Claim::Claim(Claim&& other) noexcept
    : file_(std::exchange(other.file_, {})),
      previous_owner_(std::move(other.previous_owner_)),
      descriptor_(other.descriptor_.release()) {}

Claim::~Claim() {
  if (!file_.empty() && is_mine()) unlink(file_.c_str());
}

void Claim::touch() const {
  futimens(descriptor_.get(), nullptr);
}

bool Claim::is_mine() const {
  return number_of(file_) == number_of(descriptor_.get());
}

/// Locked before it can be seen, so that no one takes its owner for dead.
std::optional<Claim> Bid::create() const {
  const fs::path own = own_name(file_);
  const int descriptor = open(own.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw_cannot_claim(file_);
  Claim claim({}, descriptor);
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  const std::string text = process_name() + "\n" + (locked ? kernel_name() : "") + "\n";
  const bool written = write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const bool linked = written && name_if_free(own, file_);
  const int error = errno;
  unlink(own.c_str());
  errno = error;
  if (!linked && (!written || error != EEXIST)) throw_cannot_claim(file_);
  if (!linked) return std::nullopt;
  claim.file_ = file_;
  return claim;
}

bool Bid::owner_died(int file) {
  const Owner owner = owner_of(file);
  owner_ = owner.process;
  if (!owner.kernel.empty() && owner.kernel == kernel_name()) {
    const bool died = flock(file, LOCK_EX | LOCK_NB) == 0;
    owner_lives_ = !died;
    return died;
  }
  struct stat status {};
  if (fstat(file, &status) != 0) return false;
  const Look look{status.st_ino, static_cast<std::uint64_t>(status.st_mtim.tv_sec),
                  static_cast<std::uint64_t>(status.st_mtim.tv_nsec)};
  const auto now = std::chrono::steady_clock::now();
  if (seen_ && *seen_ == look) return now - since_ >= life_;
  owner_lives_ = seen_.has_value();  // it has changed
  seen_ = look;
  since_ = now;
  return false;
}

/// Of all who move the file of the dead away only one finds it there.
std::optional<Claim> Bid::take_over(int file) {
  const fs::path aside = own_name(file_);
  if (std::rename(file_.c_str(), aside.c_str()) != 0) return std::nullopt;
  const bool was_it = number_of(aside) == number_of(file);
  // Another process may have taken it over just before, so that it is a fresh claim: then it is restored.
  if (!was_it) name_if_free(aside, file_);
  unlink(aside.c_str());
  if (!was_it) return std::nullopt;
  std::optional<Claim> claim = create();
  if (claim) claim->previous_owner_ = owner_;
  return claim;
}

std::optional<Claim> Bid::take() {
  if (std::optional<Claim> claim = create()) return claim;
  // Opened anew each time: a network file system looks at the file itself only then.
  const files::Descriptor file(open(file_.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) {
    if (errno == ENOENT) return create();
    throw_cannot_claim(file_);
  }
  return owner_died(file.get()) ? take_over(file.get()) : std::nullopt;
}

}  // namespace whittle::batch
