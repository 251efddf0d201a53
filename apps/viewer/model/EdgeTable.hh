/// \file
/// Every edge of a mesh with what is worth knowing of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

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

/// The edges of all sets, ready to be drawn.
class EdgeSets {
 public:
  using Ends = std::array<std::uint32_t, 2>;

  EdgeSets() = default;
  explicit EdgeSets(const std::vector<Edge>& edges);

  /// The ends of all edges of a set. Of the features that is every plain edge, the sharpest first: so another
  /// angle is another count, and nothing has to be chosen or moved.
  const std::vector<Ends>& of(EdgeSet set) const { return ends_[static_cast<std::size_t>(set)]; }

  /// How many of them belong to the set, from the first on.
  /// \param feature_angle  degrees
  std::size_t count(EdgeSet set, double feature_angle) const;

 private:
  std::array<std::vector<Ends>, 4> ends_;  ///< by EdgeSet
  std::vector<float> angles_;              ///< of the features
};

}  // namespace whittle::viewer
