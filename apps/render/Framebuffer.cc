#include "render/Framebuffer.hh"

#include <algorithm>
#include <array>

namespace whittle::render {
namespace {

void attach(const GlObject<RenderbufferKind>& storage, GLenum format, GLenum attachment, int samples,
            int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, storage.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, storage.name());
}

/// \param name  of a limit that is one number
GLint limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

}  // namespace

Image read_pixels(int width, int height) {
  const std::size_t stride = 4 * static_cast<std::size_t>(width);
  Image image{width, height, std::vector<std::uint8_t>(stride * height)};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());

  // OpenGL's first row is the lowest.
  for (int y = 0; y < height / 2; ++y)
    std::swap_ranges(image.rgba.begin() + y * stride, image.rgba.begin() + (y + 1) * stride,
                     image.rgba.begin() + (height - 1 - y) * stride);
  return image;
}

Framebuffer::Framebuffer(int width, int height, int samples) : width_(width), height_(height) {
  std::array<GLint, 2> viewport{};  // of width and height
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  const GLint largest = std::min({limit(GL_MAX_RENDERBUFFER_SIZE), viewport[0], viewport[1]});
  if (width < 1 || height < 1 || width > largest || height > largest)
    throw RenderError("the image size must be between 1x1 and " + std::to_string(largest) + "x" +
                      std::to_string(largest) + " on this device");
  samples = std::min(samples, limit(GL_MAX_SAMPLES));
  drawn_ = make_target(samples);
  if (samples > 1) resolved_ = make_target(1);
  bind();
}

Framebuffer::Target Framebuffer::make_target(int samples) const {
  Target target;
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
  attach(target.colour, GL_RGBA8, GL_COLOR_ATTACHMENT0, samples, width_, height_);
  attach(target.depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, samples, width_, height_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || glGetError() != GL_NO_ERROR)
    throw RenderError("the device gives no framebuffer of " + std::to_string(width_) + "x" +
                      std::to_string(height_) + " pixels");
  return target;
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_->framebuffer.name());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::copy_to(GLuint framebuffer, int x, int y) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

Image Framebuffer::read() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_->framebuffer.name());
  if (resolved_) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_->framebuffer.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_->framebuffer.name());
  }
  Image image = read_pixels(width_, height_);
  bind();
  return image;
}

}  // namespace whittle::render
