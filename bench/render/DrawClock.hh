/// \file
/// How long the device takes to draw something, without waiting for it.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>

#include "render/GlObject.hh"

namespace whittle::render {

/// Times what is drawn between begin() and end(), frame after frame; the answer comes some frames later.
/// Only one may run at a time (OpenGL's rule).
class DrawClock {
 public:
  void begin();
  void end();
  void forget();  ///< what is drawn has changed

  /// The median of the last frames; none before the first answer, or where the driver cannot count.
  std::optional<double> milliseconds() const;

 private:
  struct Slot {
    GlObject<QueryKind> query;
    bool asked = false, stale = false;
  };
  void collect(Slot& slot);

  std::array<Slot, 4> slots_;
  std::size_t next_ = 0;
  bool running_ = false;
  std::deque<double> last_;
};

}  // namespace whittle::render
