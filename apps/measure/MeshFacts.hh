/// \file
/// Counts and sizes of one mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// Counts and sizes of a mesh, all from its arrays alone. Lengths are in model units.
///
/// A face with a vertex twice counts in `faces` and `degenerate_faces` and takes no part in any other count:
/// it has no inside that could connect, border or use anything.
struct MeshFacts {
  std::size_t vertices = 0;           ///< all points, isolated ones included
  std::size_t faces = 0;              ///< all triangles
  std::size_t edges = 0;              ///< undirected, distinct
  std::size_t boundary_edges = 0;     ///< edges of one face
  std::size_t boundary_loops = 0;     ///< connected chains of boundary edges
  std::size_t nonmanifold_edges = 0;  ///< edges of three or more faces, or of two that disagree in direction
  std::size_t nonmanifold_vertices = 0;  ///< vertices whose faces form more than one fan; edges connect
                                         ///< a fan, however many faces they have
  std::size_t isolated_vertices = 0;     ///< vertices of no face
  std::size_t degenerate_faces = 0;  ///< a vertex twice, or an area below 1e-12 of the longest edge squared
  std::size_t duplicate_faces = 0;   ///< faces on the same three vertices as an earlier one
  std::size_t components = 0;        ///< pieces connected through edges
  long euler_characteristic = 0;     ///< V - E + F, without isolated vertices and faces with a vertex twice
  double area = 0;
  double volume = 0;  ///< signed, by the divergence theorem; meaningful where closed
  double mean_edge = 0, min_edge = 0, max_edge = 0;
  double diagonal = 0;  ///< of the bounding box
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero(), box_max = Eigen::Vector3d::Zero();

  bool closed() const { return boundary_edges == 0 && nonmanifold_edges == 0 && edges > 0; }
};

/// \pre every index is in range. Any triangle soup will do, the empty mesh included (all figures are 0).
MeshFacts facts(const IndexedMesh& mesh);

}  // namespace whittle::measure
