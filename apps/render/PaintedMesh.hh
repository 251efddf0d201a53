/// \file
/// Meshes drawn with a texture or with colours on them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/Camera.hh"
#include "render/GlObject.hh"
#include "render/Renderer.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::render {

/// What the corners' values are.
enum class Paint {
  colours,  ///< red, green, blue, 0..1
  checker  ///< places u, v in a texture, from 0 to 1; the texture is a checker of 32 by 32 whose hue tells the place
};

/// A mesh in the memory of the graphics device, with values at the corners of its faces: those of a vertex may differ.
class PaintedMesh {
 public:
  /// \param corners  for each face the values at its corners
  /// \pre every triangle index is below the number of points, and a context is current.
  PaintedMesh(const IndexedMesh& mesh, const std::vector<std::array<Eigen::Vector3f, 3>>& corners,
              Paint paint);

  Paint paint() const { return paint_; }
  const Eigen::Vector3d& origin() const { return origin_; }  ///< see MeshArrays
  void draw() const;                                         ///< with the program in use

 private:
  GlObject<VertexArrayKind> vertex_array_;
  GlObject<BufferKind> positions_, normals_, values_;
  Eigen::Vector3d origin_;
  std::size_t corners_;
  Paint paint_;
};

/// The light is the eye's own, so that the paint decides how a picture looks; faces seen from behind are as bright.
class PaintedRenderer {
 public:
  /// \pre as of Renderer.
  /// \throw RenderError  the driver does not take the shaders.
  PaintedRenderer();

  /// Clears the bound framebuffer and draws the mesh into its viewport.
  void draw(const PaintedMesh& mesh, const Camera& camera, const Look& look = {}) const;

 private:
  GlObject<ProgramKind> program_;
};

}  // namespace whittle::render
