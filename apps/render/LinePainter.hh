/// \file
/// Lines and dots over a mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/Camera.hh"
#include "render/GlObject.hh"
#include "render/MeshBuffers.hh"

namespace whittle::render {

/// Points in the memory of the graphics device, to be drawn as dots, or each two as the ends of a line.
class PointBuffer {
 public:
  /// \param origin  was subtracted from the points before rounding to float, as in MeshArrays.
  PointBuffer(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& origin);
  /// Lines between points of a mesh, whose positions they share.
  PointBuffer(const MeshBuffers& mesh, const std::vector<std::array<std::uint32_t, 2>>& ends);

  std::size_t size() const {
    return size_;
  }  ///< how many points, those of a mesh as often as they end a line
  const Eigen::Vector3d& origin() const { return origin_; }
  void draw(GLenum mode, Part part = {}) const;

 private:
  GlObject<VertexArrayKind> vertex_array_;
  GlObject<BufferKind> buffer_;  ///< of positions, or of indices into a mesh's
  bool indexed_;
  Eigen::Vector3d origin_;
  std::size_t size_;
};

/// Draws over what is there, hidden by what lies clearly in front. Colours are red, green, blue and opacity;
/// widths are in pixels, as drivers need not draw lines wider than one, these are thin rectangles.
class LinePainter {
 public:
  /// \pre as of Renderer.
  /// \throw RenderError  the driver does not take the shaders.
  LinePainter();

  /// \param part  in lines.
  void draw_lines(const PointBuffer& ends, const Camera& camera, const Eigen::Vector4f& colour, float width,
                  Part part = {}) const;
  void draw_dots(const PointBuffer& points, const Camera& camera, const Eigen::Vector4f& colour, float width,
                 Part part = {}) const;

 private:
  void draw(const PointBuffer& points, const Camera& camera, const Eigen::Vector4f& colour, float width,
            GLenum mode, Part part) const;

  GlObject<ProgramKind> lines_, dots_;
};

}  // namespace whittle::render
