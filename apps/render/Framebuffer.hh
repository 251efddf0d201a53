/// \file
/// A picture off the screen to draw into.
#pragma once

#include <optional>

#include "render/GlObject.hh"
#include "render/Image.hh"

namespace whittle::render {

/// The lower left part of what has been drawn into the bound framebuffer, which must have one sample a pixel.
/// Waits until the device is done.
Image read_pixels(int width, int height);

/// Eight-bit RGBA colour and 24-bit depth.
class Framebuffer {
 public:
  /// \param samples  for each pixel; 1 draws plainly, 4 smooths the edges. The device may give fewer.
  /// \throw RenderError  the size is not positive or more than the device can do.
  Framebuffer(int width, int height, int samples = 1);

  /// Drawing goes here from now on, over the whole picture.
  void bind() const;

  /// Copies the picture into another framebuffer of OpenGL (0 is the window's), with its lower left corner at
  /// a pixel there, and goes on with that one bound. What does not fit is cut off. One with several samples
  /// is smoothed on the way, which works into another Framebuffer only.
  void copy_to(GLuint framebuffer, int x, int y) const;

  GLuint name() const { return drawn_->framebuffer.name(); }

  /// What has been drawn. Waits until the device is done.
  Image read() const;

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  /// A framebuffer object with the storage behind it.
  struct Target {
    GlObject<FramebufferKind> framebuffer;
    GlObject<RenderbufferKind> colour, depth;
  };
  Target make_target(int samples) const;

  int width_, height_;
  std::optional<Target> drawn_;
  std::optional<Target> resolved_;  ///< one sample a pixel; only where `drawn_` has more
};

}  // namespace whittle::render
