#include "batch/Child.hh"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace whittle::batch {
namespace {

/// Only what may be called between fork and exec.
[[noreturn]] void become(char* const* arguments, int errors, const Limits& limits, pid_t parent) {
  setpgid(0, 0);                        // a key that interrupts the batch is the batch's to handle
  prctl(PR_SET_PDEATHSIG, SIGKILL);     // however the batch dies
  if (getppid() != parent) _exit(127);  // it has died just now
  if (limits.megabytes) {
    rlimit limit{};
    limit.rlim_cur = limit.rlim_max = static_cast<rlim_t>(*limits.megabytes) << 20;
    setrlimit(RLIMIT_AS, &limit);
  }
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  execv(arguments[0], arguments);
  _exit(127);
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t newline = text.rfind('\n');
  if (newline != std::string::npos) text.erase(0, newline + 1);
  constexpr std::size_t kMost = 500;
  if (text.size() > kMost) text = text.substr(0, kMost) + "...";
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const Limits& limits)
    : begin_(std::chrono::steady_clock::now()), seconds_(limits.seconds) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become(words.data(), ends[1], limits, parent);
  const int error = errno;
  close(ends[1]);
  errors_ = ends[0];
  if (process_ < 0) {
    close(errors_);
    throw std::system_error(error, std::generic_category(), "fork");
  }
  fcntl(errors_, F_SETFL, O_NONBLOCK);
}

Child::Child(Child&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      errors_(std::exchange(other.errors_, -1)),
      text_(std::move(other.text_)),
      begin_(other.begin_),
      seconds_(other.seconds_),
      killed_(other.killed_) {}

Child::~Child() {
  if (process_ > 0) {
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (errors_ >= 0) close(errors_);
}

void Child::read_errors() {
  char buffer[4096];
  for (ssize_t n; (n = read(errors_, buffer, sizeof buffer)) > 0;) {
    text_.append(buffer, static_cast<std::size_t>(n));
    constexpr std::size_t kKept = 65536;  // only the last line is used
    if (text_.size() > kKept) text_.erase(0, text_.size() - kKept / 2);
  }
}

std::optional<Ending> Child::poll() {
  read_errors();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  if (seconds_ && elapsed.count() > *seconds_ && !killed_) {
    killed_ = true;
    kill(process_, SIGKILL);
  }
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  process_ = -1;
  read_errors();
  Ending ending;
  ending.how = killed_               ? Ending::How::timed_out
               : WIFSIGNALED(status) ? Ending::How::signalled
                                     : Ending::How::exited;
  ending.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  ending.message = last_line(text_);
  ending.seconds = elapsed.count();
  return ending;
}

}  // namespace whittle::batch
