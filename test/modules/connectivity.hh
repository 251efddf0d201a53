/// \file
/// Whether two OpenMesh meshes have the same half-edges.
#pragma once

#include "OpenMeshFixture.hh"

namespace fixture {

/// With all status properties, as those are what tells what is deleted.
inline Mesh with_status(const meshes::IndexedMesh& in) {
  Mesh mesh = to_openmesh<Mesh>(in);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  return mesh;
}

/// All that is alive, and what is.
inline void require_same_connectivity(Mesh& a, Mesh& b) {
  for (const auto v : a.all_vertices()) {
    REQUIRE(a.status(v).deleted() == b.status(v).deleted());
    if (!a.status(v).deleted()) REQUIRE(a.halfedge_handle(v) == b.halfedge_handle(v));
  }
  for (const auto f : a.all_faces()) {
    REQUIRE(a.status(f).deleted() == b.status(f).deleted());
    if (!a.status(f).deleted()) REQUIRE(a.halfedge_handle(f) == b.halfedge_handle(f));
  }
  for (const auto h : a.all_halfedges()) {
    REQUIRE(a.status(a.edge_handle(h)).deleted() == b.status(b.edge_handle(h)).deleted());
    if (a.has_halfedge_status()) REQUIRE(a.status(h).deleted() == b.status(h).deleted());
    if (a.status(a.edge_handle(h)).deleted()) continue;
    REQUIRE(a.to_vertex_handle(h) == b.to_vertex_handle(h));
    REQUIRE(a.next_halfedge_handle(h) == b.next_halfedge_handle(h));
    REQUIRE(a.prev_halfedge_handle(h) == b.prev_halfedge_handle(h));
    REQUIRE(a.face_handle(h) == b.face_handle(h));
  }
}

}  // namespace fixture
