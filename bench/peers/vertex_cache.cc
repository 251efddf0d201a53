#include "peers/vertex_cache.hh"

#include <meshoptimizer.h>

namespace whittle::peers {

IndexedMesh vertex_cache_order(const IndexedMesh& mesh) {
  IndexedMesh out = mesh;
  if (mesh.triangles.empty()) return out;
  meshopt_optimizeVertexCache(out.triangles.front().data(), mesh.triangles.front().data(),
                              3 * mesh.triangles.size(), mesh.points.size());
  return out;
}

double cache_misses_per_triangle(const IndexedMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  return static_cast<double>(meshopt_analyzeVertexCache(mesh.triangles.front().data(),
                                                        3 * mesh.triangles.size(), mesh.points.size(), 16, 0,
                                                        0)
                                 .acmr);
}

}  // namespace whittle::peers
