/// \file
/// A POSIX file descriptor that closes itself.
#pragma once

#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

namespace whittle::files {

class Descriptor {
 public:
  /// \param number  what open() gave, -1 included
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  int get() const { return number_; }

  /// Gives the number away; it is not closed any more.
  int release() { return std::exchange(number_, -1); }

  /// Closes now; some file systems report a failed write only here.
  /// \return what close() gave
  int close() { return ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

/// strerror, but safe with threads.
inline std::string error_text(int error) {
  return std::generic_category().message(error);
}

}  // namespace whittle::files
