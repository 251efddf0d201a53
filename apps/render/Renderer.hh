/// \file
/// Draws meshes as a lit solid. Independent of windows and of where the context comes from.
#pragma once

#include <Eigen/Core>
#include <string>

#include "render/Camera.hh"
#include "render/GlObject.hh"
#include "render/MeshBuffers.hh"

namespace whittle::render {

/// Colours as they come out on the screen (sRGB), each part in [0, 1].
struct Look {
  Eigen::Vector3f front = {0.88f, 0.80f, 0.72f};       ///< clay
  Eigen::Vector3f back = {0.80f, 0.22f, 0.18f};        ///< inner side: a hole in the surface shows up red
  Eigen::Vector3f background = {0.34f, 0.37f, 0.40f};  ///< cool, so neither side is ever taken for it
};

/// Makes the bound framebuffer empty, within the scissors if they are on.
void clear(const Look& look);

/// The three lights are fixed to the eye, so a model looks the same from every side: a key light from the
/// upper left, a weak fill from the right, a headlight; besides them a sky that is brighter above than below.
class Renderer {
 public:
  /// \pre a context of OpenGL 3.3 core or later is current; the same one must be at every later call.
  /// \throw RenderError  the driver does not take the shaders.
  Renderer();

  /// Clears the bound framebuffer and draws the mesh into its viewport.
  void draw(const MeshBuffers& mesh, const Camera& camera, const Look& look = {}) const;

  /// Some triangles of the mesh, over what is there. All parts one after the other give the whole picture.
  void draw_part(const MeshBuffers& mesh, const Camera& camera, const Look& look, Part part) const;

 private:
  GlObject<ProgramKind> program_;
  GLint model_view_, projection_, front_, back_;
};

}  // namespace whittle::render
