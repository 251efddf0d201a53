/// \file
/// Lines and dots over a mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "render/Camera.hh"
#include "render/GlObject.hh"

namespace whittle::render {

/// Points in the memory of the graphics device, to be drawn as dots, or each two as the ends of a line.
class PointBuffer {
 public:
  /// \param origin  is subtracted before rounding to float, as in MeshBuffers.
  PointBuffer(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin);

  std::size_t size() const { return size_; }
  const Eigen::Vector3d& origin() const { return origin_; }
  void draw(GLenum mode) const;

 private:
  GlObject<VertexArrayKind> vertex_array_;
  GlObject<BufferKind> positions_;
  Eigen::Vector3d origin_;
  std::size_t size_;
};

/// Draws over what is there, hidden by what lies clearly in front. Colours are red, green, blue and opacity;
/// widths are in pixels, as drivers need not draw lines wider than one, these are thin rectangles.
class LinePainter {
 public:
  /// \pre as of Renderer. \throw RenderError  the driver does not take the shaders.
  LinePainter();

  void draw_lines(const PointBuffer& ends, const Camera& camera, const Eigen::Vector4f& colour,
                  float width) const;
  void draw_dots(const PointBuffer& points, const Camera& camera, const Eigen::Vector4f& colour,
                 float width) const;

 private:
  void draw(const PointBuffer& points, const Camera& camera, const Eigen::Vector4f& colour, float width,
            GLenum mode) const;

  GlObject<ProgramKind> lines_, dots_;
};

}  // namespace whittle::render
