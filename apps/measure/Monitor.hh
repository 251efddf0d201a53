/// \file
/// Following a measurement, and ending it.
#pragma once

#include <exception>
#include <functional>

namespace whittle::measure {

/// Follows a measurement and may end it: called now and then with the part that is done, from 0 to 1, by any
/// of the threads that measure, but never by two at once; false ends it with Cancelled. Must not throw.
using Monitor = std::function<bool(double done)>;

/// A monitor ended the measurement.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace whittle::measure
