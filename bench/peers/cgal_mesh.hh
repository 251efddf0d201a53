/// \file
/// From arrays to CGAL's mesh and back. Only for sources that are compiled where CGAL is found.
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

using CgalKernel = CGAL::Simple_cartesian<double>;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

/// Faces that are not manifold are refused, as by OpenMesh.
template <typename Real>
void fill(CgalMesh& surface, const IndexedMeshT<Real>& mesh) {
  using Vertex = CgalMesh::Vertex_index;
  const auto n = [](std::size_t count) { return static_cast<CgalMesh::size_type>(count); };
  surface.reserve(n(mesh.points.size()), n(mesh.triangles.size() * 3 / 2), n(mesh.triangles.size()));
  for (const auto& p : mesh.points)
    surface.add_vertex(CgalKernel::Point_3(double(p[0]), double(p[1]), double(p[2])));
  for (const auto& [a, b, c] : mesh.triangles) surface.add_face(Vertex(a), Vertex(b), Vertex(c));
}

/// What a simplification has left; collects the garbage first.
template <typename Real>
IndexedMeshT<Real> taken(CgalMesh& surface) {
  surface.collect_garbage();
  IndexedMeshT<Real> out;
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    out.points.push_back(Eigen::Vector3d(p.x(), p.y(), p.z()).template cast<Real>());
  }
  for (const auto f : surface.faces()) {
    typename IndexedMeshT<Real>::Triangle t{};
    int corner = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      t[corner++] = static_cast<std::uint32_t>(v.idx());
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace whittle::bench
