/// \file
/// Simplifiers down to a number of triangles, to compare with: other libraries', and mq.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

struct PeerResult {
  IndexedMesh mesh;
  double milliseconds = 0;  ///< the simplifier alone; its own mesh structure was filled before
};

struct Peer {
  std::string name;   ///< "openmesh", "meshopt", "mq", "cgal"
  std::string label;  ///< for readers
  PeerResult (*simplify)(const IndexedMesh& mesh, std::size_t triangles);
};

/// OpenMesh's DecimaterT with ModQuadricT, meshopt_simplify, mq, and, where CMake found it, CGAL with Lindstrom
/// and Turk's policies.
const std::vector<Peer>& peers();

}  // namespace whittle::bench
