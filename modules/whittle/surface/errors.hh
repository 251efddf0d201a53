/// \file
/// What the library throws when a caller makes a mistake. It never prints and never exits.
#pragma once

#include <stdexcept>
#include <string>

namespace whittle {

/// A parameter is outside its range: a negative length, an angle above 180 degrees, NaN.
class InvalidParameter : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A planner, module or decimater is used before it knows enough: no threshold, no target, no `initialize()`, no module
/// that it could follow. `what()` names what is missing.
class NotReady : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The mesh cannot be planned on: a face is not a triangle, or a coordinate is not finite.
class InvalidMesh : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace whittle
