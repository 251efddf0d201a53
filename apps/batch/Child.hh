/// \file
/// A program run in a process of its own, with limits.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace whittle::batch {

struct Limits {
  std::optional<double> seconds;         ///< wall-clock time; then it is killed
  std::optional<std::size_t> megabytes;  ///< of address space, 2^20 bytes
};

/// How it ended.
struct Ending {
  enum class How { exited, signalled, timed_out };
  How how = How::exited;
  int code = 0;         ///< exit code or number of the signal
  std::string message;  ///< the last line that it wrote to standard error, shortened
  double seconds = 0;

  bool succeeded() const { return how == How::exited && code == 0; }
};

/// Started by the constructor; killed by the destructor if it still runs, and when this process or thread dies.
class Child {
 public:
  /// \param arguments  the program's path first
  /// \throw std::system_error  no process could be made
  Child(const std::vector<std::string>& arguments, const Limits& limits);
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();

  /// How it ended, once it has. Kills it when its time is over.
  std::optional<Ending> poll();

  /// Ends once it writes something or ends; for waiting on several at once.
  int descriptor() const { return errors_; }

 private:
  void read_errors();

  pid_t process_ = -1;
  int errors_ = -1;  // what it writes to standard error
  std::string text_;
  std::chrono::steady_clock::time_point begin_;
  std::optional<double> seconds_;
  bool killed_ = false;
};

}  // namespace whittle::batch
