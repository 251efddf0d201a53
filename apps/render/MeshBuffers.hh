/// \file
/// A mesh in the memory of the graphics device.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "render/GlObject.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::render {

/// One unit normal a vertex: the normals of its faces weighted by their areas, so that slivers do not tilt
/// it. A vertex without a face of positive area gets (0, 0, 1).
std::vector<Eigen::Vector3f> vertex_normals(const IndexedMesh& mesh);

/// The box around all points; empty for a mesh without points.
Eigen::AlignedBox3d bounding_box(const IndexedMesh& mesh);

/// A mesh as the graphics memory takes it. Made without a context, so on any thread.
struct MeshArrays {
  explicit MeshArrays(const IndexedMesh& mesh);

  /// What was subtracted from every point before rounding to float: models far from zero keep their digits.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3f> positions, normals;  ///< one of each for each point
};

/// Some of the triangles, lines or points that could be drawn; by default all of them.
struct Part {
  std::size_t first = 0, count = std::numeric_limits<std::size_t>::max();

  /// How many that are where there are `all` in all.
  std::size_t of(std::size_t all) const { return first < all ? std::min(count, all - first) : 0; }
};

/// Positions and normals as 32-bit floats, indices as 32-bit integers, in the order of the mesh: nothing is
/// sorted for the vertex cache, so a benchmark draws the mesh as it was handed over.
class MeshBuffers {
 public:
  /// \param values  one for each point, for a HeatPainter; or none.
  /// \pre every triangle index is below the number of points, and a context is current.
  explicit MeshBuffers(const IndexedMesh& mesh, const std::vector<float>& values = {})
      : MeshBuffers(MeshArrays(mesh), mesh.triangles, values) {}

  /// The same from arrays that were made before.
  MeshBuffers(const MeshArrays& arrays, const std::vector<IndexedMesh::Triangle>& triangles,
              const std::vector<float>& values = {});

  /// Draws triangles with the program in use.
  void draw(Part part = {}) const;

  std::size_t triangles() const { return triangles_; }
  const Eigen::Vector3d& origin() const { return origin_; }  ///< see MeshArrays
  GLuint positions() const { return positions_.name(); }     ///< three floats a point

 private:
  GlObject<VertexArrayKind> vertex_array_;
  GlObject<BufferKind> positions_, normals_, values_, indices_;
  Eigen::Vector3d origin_;
  std::size_t triangles_;
};

}  // namespace whittle::render
