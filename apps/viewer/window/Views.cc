#include "window/Views.hh"

#include <algorithm>

namespace whittle::viewer {
namespace {

bool fits(const std::optional<render::Framebuffer>& framebuffer, int width, int height) {
  return framebuffer && framebuffer->width() == width && framebuffer->height() == height;
}

}  // namespace

void Views::begin(Detail detail, Scene& scene, const Session& session) {
  sight_ = wanted_;
  models_ = scene.models();
  stage_ = Stage::painted;  // and stays so if there is no room for it
  if (!fits(canvas_, sight_.width, sight_.height)) {
    canvas_.reset();
    canvas_.emplace(sight_.width, sight_.height, samples_);
  }
  painting_ = Painting(scene.strokes(session, sight_, detail));
  stage_ = detail == Detail::full ? Stage::painting : Stage::sketching;
}

bool Views::paint(double milliseconds, Scene& scene, const Session& session, const Painting::Clock& clock) {
  if (complete()) return false;
  if (!(wanted_ == sight_) && stage_ != Stage::sketching)
    begin(slow_ ? Detail::sketch : Detail::full, scene, session);
  else if (stage_ == Stage::sketched)
    begin(Detail::full, scene, session);
  canvas_->bind();
  painting_.advance(milliseconds, clock);
  glDisable(GL_SCISSOR_TEST);
  const bool full = stage_ == Stage::painting;
  if (full && painting_.milliseconds() > milliseconds) slow_ = true;
  if (!painting_.done()) {
    const bool shows_another = seen_models_ != models_;
    if (shows_another) show_what_there_is();  // better than another model
    return shows_another;
  }
  if (full) slow_ = painting_.milliseconds() > milliseconds;
  ++(full ? pictures_ : sketches_);
  stage_ = full ? Stage::painted : Stage::sketched;
  painting_ = Painting();
  seen_models_ = models_;
  show_what_there_is();
  return true;
}

void Views::show_what_there_is() {
  if (!fits(shown_, canvas_->width(), canvas_->height())) {
    shown_.reset();
    shown_.emplace(canvas_->width(), canvas_->height());
  }
  canvas_->copy_to(shown_->name(), 0, 0);
}

void Views::show(const Rect& area, int height) const {
  const int bottom = height - area.y - area.height;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!fits(shown_, area.width, area.height)) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, bottom, std::max(area.width, 0), std::max(area.height, 0));
    render::clear(look());
    glDisable(GL_SCISSOR_TEST);
  }
  // After a change of the window's size the last picture stays in the upper left corner; panels cover what is
  // too wide.
  if (shown_) shown_->copy_to(0, area.x, height - area.y - shown_->height());
}

void paint_whole(Scene& scene, const Session& session, const Sight& sight, const Rect& area,
                 const render::Framebuffer& framebuffer) {
  if (area.width < 1 || area.height < 1) return;
  const render::Framebuffer canvas(area.width, area.height, kPictureSamples);
  Painting(scene.strokes(session, sight, Detail::full)).finish();
  canvas.copy_to(framebuffer.name(), area.x, framebuffer.height() - area.y - area.height);
}

}  // namespace whittle::viewer
