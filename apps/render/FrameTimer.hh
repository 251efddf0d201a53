/// \file
/// How long many frames take together.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace whittle::render {

/// Which frames are timed: those from number `from` up to, not with, number `to`; the ones before warm up.
struct FrameRange {
  std::size_t from = 100, to = 1100;
  std::size_t timed() const { return to - from; }
};

/// The time of all timed frames together.
struct SpanTime {
  double wall_ms = 0;           ///< steady clock, between two `glFinish`
  std::optional<double> gl_ms;  ///< `GL_TIME_ELAPSED` over the same span; none where the driver cannot count
};

/// Calls `draw_frame` `range.to` times. Each frame is handed to the driver (`glFlush`) as a swap of buffers
/// would, but not waited for: waiting in each frame would time the waiting.
/// \pre range.from < range.to
SpanTime time_frames(const std::function<void()>& draw_frame, const FrameRange& range = {});

}  // namespace whittle::render
