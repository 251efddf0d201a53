#include "whittle/openmesh/SnapshotT.hh"

#include "OpenMeshFixture.hh"

using namespace whittle;
using fixture::Mesh;

TEST_CASE("a snapshot is of a mesh until its faces change or more of its vertices are held") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::flat_grid(3));
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.status(Mesh::VertexHandle(4)).set_locked(true);
  const detail::SnapshotT<Mesh> snapshot(mesh);
  CHECK(snapshot.is_of(mesh));
  mesh.set_point(Mesh::VertexHandle(4), {1, 1, 7});
  mesh.status(Mesh::VertexHandle(4)).set_locked(false);
  CHECK(snapshot.is_of(mesh));
  for (const int face : {0, 7}) {  // the first and the last
    Mesh smaller = mesh;
    smaller.delete_face(smaller.face_handle(static_cast<unsigned>(face)), false);
    CHECK_FALSE(snapshot.is_of(smaller));
    CHECK_FALSE(detail::SnapshotT<Mesh>(smaller).is_of(mesh));
  }
  Mesh held = mesh;
  held.status(Mesh::VertexHandle(3)).set_feature(true);
  CHECK_FALSE(snapshot.is_of(held));
  mesh.add_vertex({9, 9, 9});
  CHECK_FALSE(snapshot.is_of(mesh));
}
