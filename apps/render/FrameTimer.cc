#include "render/FrameTimer.hh"

#include <chrono>

#include "render/GlObject.hh"

namespace whittle::render {
namespace {

/// Runs an OpenGL timer for its lifetime.
class ElapsedQuery {
 public:
  ElapsedQuery() {
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits_);
    if (bits_ > 0) glBeginQuery(GL_TIME_ELAPSED, query_.name());
  }
  ~ElapsedQuery() { end(); }
  ElapsedQuery(const ElapsedQuery&) = delete;
  ElapsedQuery& operator=(const ElapsedQuery&) = delete;

  void end() {
    if (bits_ > 0 && running_) glEndQuery(GL_TIME_ELAPSED);
    running_ = false;
  }

  std::optional<double> milliseconds() const {
    if (bits_ == 0) return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) / 1e6;
  }

 private:
  GlObject<QueryKind> query_;
  GLint bits_ = 0;
  bool running_ = true;
};

void draw_frames(const std::function<void()>& draw_frame, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    draw_frame();
    glFlush();
  }
}

}  // namespace

SpanTime time_frames(const std::function<void()>& draw_frame, const FrameRange& range) {
  draw_frames(draw_frame, range.from);
  glFinish();

  const auto start = std::chrono::steady_clock::now();
  ElapsedQuery query;
  draw_frames(draw_frame, range.timed());
  query.end();
  glFinish();
  const auto stop = std::chrono::steady_clock::now();

  return {std::chrono::duration<double, std::milli>(stop - start).count(), query.milliseconds()};
}

}  // namespace whittle::render
