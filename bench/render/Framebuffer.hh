/// \file
/// A picture off the screen to draw into.
#pragma once

#include <optional>

#include "render/GlObject.hh"
#include "render/Image.hh"

namespace whittle::render {

/// Eight-bit RGBA colour and 24-bit depth.
class Framebuffer {
 public:
  /// \param samples  for each pixel; 1 draws plainly, 4 smooths the edges. The device may give fewer.
  /// \throw RenderError  the size is not positive or more than the device can do.
  Framebuffer(int width, int height, int samples = 1);

  /// Drawing goes here from now on, over the whole picture.
  void bind() const;

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
