/// \file
/// Draws meshes for those who look closely: flat faces, colours by a figure, wires.
#pragma once

#include <Eigen/Core>

#include "render/Camera.hh"
#include "render/GlObject.hh"
#include "render/MeshBuffers.hh"
#include "render/Renderer.hh"
#include "render/ValueBuffer.hh"

namespace whittle::render {

/// How the surface is drawn. The lights are the Renderer's.
struct SurfaceStyle {
  bool flat = false;                    ///< one normal a face instead of one a vertex
  bool lit = true;                      ///< false: in the plain colours, as what hides the wires behind
  const ValueBuffer* values = nullptr;  ///< heat colours instead of the look's front, by the mesh's vertices
  float value_at_top = 1;               ///< the value that gets the last colour; above 0
};

/// Unlike the Renderer, this clears nothing: it draws over what is there.
class SurfacePainter {
 public:
  /// \pre as of Renderer.
  /// \throw RenderError  the driver does not take the shaders.
  SurfacePainter();

  void draw(const MeshBuffers& mesh, const Camera& camera, const SurfaceStyle& style, const Look& look = {},
            Part part = {}) const;

  /// The edges of all faces, one pixel wide; those of faces seen from behind in the colour `back`. Colours
  /// are red, green, blue and opacity. Draw the faces with a PushBack before, or they hide half of the wires.
  void draw_wires(const MeshBuffers& mesh, const Camera& camera, const Eigen::Vector4f& front,
                  const Eigen::Vector4f& back, Part part = {}) const;

 private:
  GlObject<ProgramKind> surface_, wires_;
};

/// During its lifetime surfaces are drawn slightly farther away (polygon offset).
class PushBack {
 public:
  PushBack() {
    glEnable(GL_POLYGON_OFFSET_FILL);
    // The same for all faces: an offset by slope would push steep front faces behind the back faces next to
    // them.
    glPolygonOffset(0.0f, 2e4f);
  }
  ~PushBack() { glDisable(GL_POLYGON_OFFSET_FILL); }
  PushBack(const PushBack&) = delete;
  PushBack& operator=(const PushBack&) = delete;
};

}  // namespace whittle::render
