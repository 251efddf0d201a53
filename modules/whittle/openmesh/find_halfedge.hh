/// \file
/// The half-edge between two vertices.
#pragma once

namespace whittle::detail {

/// The half-edge from one vertex to another, invalid if there is none. The time depends on the vertex with fewer edges
/// only: it goes around both at once.
template <typename Mesh>
typename Mesh::HalfedgeHandle find_halfedge(const Mesh& mesh, typename Mesh::VertexHandle from,
                                            typename Mesh::VertexHandle to) {
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;
  const auto rotated = [&](HalfedgeHandle h) {
    return mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
  };
  const HalfedgeHandle start_a = mesh.halfedge_handle(from), start_b = mesh.halfedge_handle(to);
  HalfedgeHandle h = start_a, o = start_b;
  if (!h.is_valid() || !o.is_valid()) return HalfedgeHandle();
  do {
    if (mesh.to_vertex_handle(h) == to) return h;
    if (mesh.to_vertex_handle(o) == from) return mesh.opposite_halfedge_handle(o);
    h = rotated(h);
    o = rotated(o);
  } while (h != start_a && o != start_b);
  return HalfedgeHandle();
}

}  // namespace whittle::detail
