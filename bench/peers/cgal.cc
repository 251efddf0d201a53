// Left out of the build where CMake does not find CGAL.
#include "peers/cgal_mesh.hh"  // first: the policies need the kernel

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <chrono>

#include "peers/Peers.hh"

namespace whittle::bench {

PeerResult simplify_cgal(const IndexedMesh& mesh, std::size_t triangles) {
  namespace smp = CGAL::Surface_mesh_simplification;
  CgalMesh surface;
  fill(surface, mesh);

  // CGAL counts edges. On a closed surface there are three for every two faces, and on any surface a collapse
  // inside takes three edges and two faces away.
  const auto faces = static_cast<std::size_t>(surface.number_of_faces());
  const auto edges = static_cast<std::size_t>(surface.number_of_edges());
  const std::size_t excess = faces > triangles ? 3 * (faces - triangles) / 2 : 0;
  const smp::Count_stop_predicate<CgalMesh> stop(edges > excess ? edges - excess + 1 : 1);
  const auto start = std::chrono::steady_clock::now();
  smp::edge_collapse(surface, stop);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return {taken<double>(surface), time.count()};
}

}  // namespace whittle::bench
