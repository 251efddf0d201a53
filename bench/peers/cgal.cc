// Left out of the build where CMake does not find CGAL.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <chrono>

#include "peers/Peers.hh"

namespace whittle::bench {

PeerResult simplify_cgal(const IndexedMesh& mesh, std::size_t triangles) {
  namespace smp = CGAL::Surface_mesh_simplification;
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Vertex = Mesh::Vertex_index;
  Mesh surface;
  for (const auto& p : mesh.points) surface.add_vertex({p.x(), p.y(), p.z()});
  // Faces that are not manifold are refused, as by OpenMesh.
  for (const auto& [a, b, c] : mesh.triangles) surface.add_face(Vertex(a), Vertex(b), Vertex(c));

  // CGAL counts edges. On a closed surface there are three for every two faces, and on any surface a collapse
  // inside takes three edges and two faces away.
  const auto faces = static_cast<std::size_t>(surface.number_of_faces());
  const auto edges = static_cast<std::size_t>(surface.number_of_edges());
  const std::size_t excess = faces > triangles ? 3 * (faces - triangles) / 2 : 0;
  const smp::Count_stop_predicate<Mesh> stop(edges > excess ? edges - excess + 1 : 1);
  const auto start = std::chrono::steady_clock::now();
  smp::edge_collapse(surface, stop);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  surface.collect_garbage();

  PeerResult result;
  result.milliseconds = time.count();
  for (const Vertex vertex : surface.vertices()) {
    const auto& p = surface.point(vertex);
    result.mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : surface.faces()) {
    IndexedMesh::Triangle triangle{};
    std::size_t corner = 0;
    for (const Vertex vertex : CGAL::vertices_around_face(surface.halfedge(face), surface))
      triangle[corner++] = static_cast<std::uint32_t>(vertex);
    result.mesh.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace whittle::bench
