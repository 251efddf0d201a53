/// \file
/// The pieces of a mesh: what hangs together through common vertices.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle {

/// The piece of each vertex, and how large the pieces are. They are counted from 0 in the order of their first vertices.
struct Pieces {
  static constexpr std::uint32_t kNone = 0xffffffffu;  ///< of a vertex in no face
  std::vector<std::uint32_t> of_vertex;
  std::vector<std::size_t> faces, vertices;  ///< for each piece

  std::size_t count() const { return faces.size(); }
};

/// \pre every index is in range
template <typename Real>
Pieces pieces_of(const IndexedMeshT<Real>& mesh) {
  detail::UnionFind sets(mesh.points.size());
  Pieces pieces;
  pieces.of_vertex.assign(mesh.points.size(), Pieces::kNone);
  for (const auto& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
    for (const std::uint32_t v : t) pieces.of_vertex[v] = 0;
  }
  for (std::uint32_t v = 0; v < pieces.of_vertex.size(); ++v) {
    if (pieces.of_vertex[v] == Pieces::kNone) continue;
    const std::uint32_t root = sets.root(v);  // the least vertex of the piece
    if (root == v) {
      pieces.of_vertex[v] = static_cast<std::uint32_t>(pieces.vertices.size());
      pieces.vertices.push_back(0);
    } else {
      pieces.of_vertex[v] = pieces.of_vertex[root];
    }
    ++pieces.vertices[pieces.of_vertex[v]];
  }
  pieces.faces.resize(pieces.vertices.size());
  for (const auto& t : mesh.triangles) ++pieces.faces[pieces.of_vertex[t[0]]];
  return pieces;
}

/// The diagonal of each piece's bounding box, in model units.
template <typename Real>
std::vector<double> piece_diagonals(const IndexedMeshT<Real>& mesh, const Pieces& pieces) {
  std::vector<Eigen::AlignedBox3d> boxes(pieces.count());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (pieces.of_vertex[v] != Pieces::kNone)
      boxes[pieces.of_vertex[v]].extend(mesh.points[v].template cast<double>());
  std::vector<double> diagonals;
  diagonals.reserve(boxes.size());
  for (const auto& box : boxes) diagonals.push_back(box.diagonal().stableNorm());
  return diagonals;
}

}  // namespace whittle
