/// \file
/// Every edge of a mesh with what is worth knowing of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "whittle/IndexedMesh.hh"

namespace whittle::viewer {

enum class EdgeKind : std::uint8_t {
  plain,       ///< between two faces that agree
  boundary,    ///< of one face
  nonmanifold  ///< of three faces or more, or of two that disagree in direction
};

struct Edge {
  std::array<std::uint32_t, 2> ends;
  float length = 0;  ///< model units
  float angle = 0;   ///< between the normals of its two faces, degrees; 0 where it is not plain
  EdgeKind kind = EdgeKind::plain;
  bool held = false;  ///< both ends must stay: a planner locks boundary and complex vertices
};

/// The edges sorted by their ends. Faces that name a vertex twice have none.
std::vector<Edge> edge_table(const IndexedMesh& mesh);

/// Which edges are drawn over a mesh.
enum class EdgeSet {
  boundary,
  nonmanifold,
  feature,  ///< sharper than an angle
  locked    ///< held, and not of the first two
};
constexpr EdgeSet kEdgeSets[] = {EdgeSet::locked, EdgeSet::feature, EdgeSet::boundary, EdgeSet::nonmanifold};
const char* name(EdgeSet set);

/// The ends of the edges of a set.
std::vector<std::array<std::uint32_t, 2>> select(const std::vector<Edge>& edges, EdgeSet set,
                                                 double feature_angle);

}  // namespace whittle::viewer
