/// \file
/// Draws a mesh in colours that stand for a figure at each point.
#pragma once

#include "render/Camera.hh"
#include "render/GlObject.hh"
#include "render/MeshBuffers.hh"

namespace whittle::render {

/// Dark violet is 0, yellow is 1 (the colours of viridis, which keep their order in print and for the
/// colour-blind); a little shade from a light at the eye shows the form.
class HeatPainter {
 public:
  /// \pre as of Renderer.
  /// \throw RenderError  the driver does not take the shaders.
  HeatPainter();

  /// Clears the bound framebuffer and draws a mesh whose buffers have values; those beyond [0, 1] are cut.
  void draw(const MeshBuffers& mesh, const Camera& camera) const;

 private:
  GlObject<ProgramKind> program_;
  GLint model_view_, projection_;
};

}  // namespace whittle::render
