/// \file
/// The part of a mesh that distances are measured on, and points spread over it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "measure/triangle.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// The faces of a mesh that are not degenerate; the others have no normal and no area to sample. Refers to
/// the mesh, which must outlive it.
class Surface {
 public:
  enum class Part { with_area, all };  ///< all: degenerate faces, too

  /// \throw InvalidMesh  no face is left, or a coordinate of a face is not finite.
  explicit Surface(const IndexedMesh& mesh, Part part = Part::with_area);
  explicit Surface(IndexedMesh&& mesh, Part part = Part::with_area) = delete;

  std::size_t size() const { return faces_.size(); }
  Corners face(std::size_t i) const { return corners(mesh_, mesh_.triangles[faces_[i]]); }

  /// Which face of the mesh face i is.
  std::uint32_t index(std::size_t i) const { return faces_[i]; }

  /// The vertices of face i.
  const IndexedMesh::Triangle& triangle(std::size_t i) const { return mesh_.triangles[faces_[i]]; }

  /// The mesh's points that belong to one of the faces.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  const Eigen::Vector3d& point(std::uint32_t vertex) const { return mesh_.points[vertex]; }

  /// Sample i of `count`, evenly spread by area: sample i lies at the fraction (i + 0.5) / count of the area
  /// summed up over the faces, so every face gets its share to within one sample; where in its face follows
  /// the R2 low-discrepancy sequence. Random points would need some hundred times more samples for the same
  /// error.
  Eigen::Vector3d sample(std::size_t i, std::size_t count) const;

  /// The face that sample i of `count` lies on.
  std::size_t sampled_face(std::size_t i, std::size_t count) const;

 private:
  const IndexedMesh& mesh_;
  std::vector<std::uint32_t> faces_;
  std::vector<std::uint32_t> vertices_;
  std::vector<double> area_up_to_;  // including the face itself
};

}  // namespace whittle::measure
