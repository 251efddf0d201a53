/// \file
/// A figure for each vertex of a mesh, in the memory of the graphics device.
#pragma once

#include <vector>

#include "render/GlObject.hh"

namespace whittle::render {

struct TextureKind {
  static GLuint create() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};

/// Kept apart from the mesh's buffers, so that figures can come and go while the mesh stays.
class ValueBuffer {
 public:
  /// \pre a context is current.
  /// \throw RenderError  more values than the device can hold.
  explicit ValueBuffer(const std::vector<float>& values);

  /// Makes them the buffer texture of this unit.
  void bind(GLuint unit) const;

 private:
  GlObject<BufferKind> buffer_;
  GlObject<TextureKind> texture_;
};

}  // namespace whittle::render
