/// \file
/// What is drawn in place of a large mesh while the view moves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/MeshBuffers.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::viewer {

/// A coarse approximation of a mesh, by mq: the most accurate of the modules at so few triangles.
struct StandIn {
  std::vector<IndexedMesh::Triangle> triangles;
  std::vector<std::uint32_t> vertex_map;  ///< vertex of the mesh to vertex of the likeness
  render::MeshArrays arrays;
};

/// How many triangles a likeness has. A software renderer draws that many in some hundredths of a second.
constexpr std::size_t kStandInTriangles = 20000;

/// Null for a mesh that needs none, as it is small itself, or of which none can be made, as in a heap of
/// single triangles every edge is a boundary.
std::shared_ptr<const StandIn> make_stand_in(const IndexedMesh& mesh,
                                             std::size_t triangles = kStandInTriangles);

/// Values of the mesh's vertices for the likeness: the root mean square of those that became one, as a few
/// that stand out are seen. Empty stays empty.
std::vector<float> values_on(const StandIn& stand_in, const std::vector<float>& values);

}  // namespace whittle::viewer
