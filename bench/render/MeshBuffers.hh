/// \file
/// A mesh in the memory of the graphics device.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "render/GlObject.hh"
#include "whittle/IndexedMesh.hh"

namespace whittle::render {

/// One unit normal a vertex: the normals of its faces weighted by their areas, so that slivers do not tilt
/// it. A vertex without a face of positive area gets (0, 0, 1).
std::vector<Eigen::Vector3f> vertex_normals(const IndexedMesh& mesh);

/// The box around all points; empty for a mesh without points.
Eigen::AlignedBox3d bounding_box(const IndexedMesh& mesh);

/// Positions and normals as 32-bit floats, indices as 32-bit integers, in the order of the mesh: nothing is
/// sorted for the vertex cache, so a benchmark draws the mesh as it was handed over.
class MeshBuffers {
 public:
  /// \param values  one for each point, for a HeatPainter; or none.
  /// \pre every triangle index is below the number of points, and a context is current.
  explicit MeshBuffers(const IndexedMesh& mesh, const std::vector<float>& values = {});

  /// Draws all triangles with the program in use.
  void draw() const;

  std::size_t triangles() const { return triangles_; }

  /// What was subtracted from every point before rounding to float: models far from zero keep their digits.
  const Eigen::Vector3d& origin() const { return origin_; }

 private:
  GlObject<VertexArrayKind> vertex_array_;
  GlObject<BufferKind> positions_, normals_, values_, indices_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::size_t triangles_ = 0;
};

}  // namespace whittle::render
