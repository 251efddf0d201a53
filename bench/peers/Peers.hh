/// \file
/// Simplifiers down to a number of triangles, to compare with: other people's, and mq.
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

/// Those that this program was built with. CGAL is one of them where CMake found it.
const std::vector<Peer>& peers();

PeerResult simplify_openmesh(const IndexedMesh& mesh, std::size_t triangles);  ///< DecimaterT, ModQuadricT
PeerResult simplify_meshopt(const IndexedMesh& mesh, std::size_t triangles);   ///< meshopt_simplify
PeerResult simplify_mq(const IndexedMesh& mesh, std::size_t triangles);        ///< Whittle's own
PeerResult simplify_cgal(const IndexedMesh& mesh, std::size_t triangles);  ///< Lindstrom and Turk's policies

/// The mesh with its triangles in meshoptimizer's order for a vertex cache; the vertices stay as they are.
IndexedMesh vertex_cache_order(const IndexedMesh& mesh);

/// Vertices fetched for each triangle by a first-in-first-out cache of 16: 0.5 is ideal, 3 the worst.
double cache_misses_per_triangle(const IndexedMesh& mesh);

}  // namespace whittle::bench
