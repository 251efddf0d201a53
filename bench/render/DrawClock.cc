#include "render/DrawClock.hh"

#include <algorithm>
#include <vector>

namespace whittle::render {
namespace {

constexpr std::size_t kFrames = 15;

}  // namespace

void DrawClock::collect(Slot& slot) {
  if (!slot.asked) return;
  GLint there = 0;
  glGetQueryObjectiv(slot.query.name(), GL_QUERY_RESULT_AVAILABLE, &there);
  if (!there) return;
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(slot.query.name(), GL_QUERY_RESULT, &nanoseconds);
  slot.asked = false;
  if (slot.stale || nanoseconds == 0) return;
  last_.push_back(static_cast<double>(nanoseconds) / 1e6);
  if (last_.size() > kFrames) last_.pop_front();
}

void DrawClock::begin() {
  for (Slot& slot : slots_) collect(slot);
  running_ = !slots_[next_].asked;  // else all are under way, and this frame goes untimed
  if (running_) glBeginQuery(GL_TIME_ELAPSED, slots_[next_].query.name());
}

void DrawClock::end() {
  if (!running_) return;
  glEndQuery(GL_TIME_ELAPSED);
  slots_[next_].asked = true;
  slots_[next_].stale = false;
  next_ = (next_ + 1) % slots_.size();
  running_ = false;
}

void DrawClock::forget() {
  last_.clear();
  for (Slot& slot : slots_) slot.stale = true;
}

std::optional<double> DrawClock::milliseconds() const {
  if (last_.empty()) return std::nullopt;
  std::vector<double> sorted(last_.begin(), last_.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

}  // namespace whittle::render
