#include "whittle/compact.hh"

#include "OpenMeshFixture.hh"
#include "measure/MeshFacts.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/SweepDecimaterT.hh"

using namespace whittle;

namespace {

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::TexCoord2D |
                     OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using RichMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// A decimated mesh with properties that tell which element each was.
struct Decimated {
  explicit Decimated(const IndexedMesh& in, double distance = 0.2)
      : mesh(fixture::to_openmesh<RichMesh>(in)) {
    mesh.update_normals();  // OpenMesh leaves attributes uninitialised
    mesh.add_property(vertex_was);
    mesh.add_property(halfedge_was);
    mesh.add_property(edge_was);
    mesh.add_property(face_was);
    mesh.add_property(tag, "tag");
    for (const auto v : mesh.vertices()) mesh.property(vertex_was, v) = v.idx();
    for (const auto h : mesh.halfedges()) mesh.property(halfedge_was, h) = h.idx();
    for (const auto h : mesh.halfedges()) mesh.set_texcoord2D(h, {0, 0});  // no seam
    for (const auto e : mesh.edges()) mesh.property(edge_was, e) = e.idx();
    for (const auto f : mesh.faces()) mesh.property(face_was, f) = f.idx();
    for (const auto v : mesh.vertices()) mesh.property(tag, v) = v.idx() % 3 == 0;
    for (const auto v : mesh.vertices()) mesh.status(v).set_selected(v.idx() % 5 == 0);
    for (const auto v : mesh.vertices())
      mesh.set_color(v, RichMesh::Color(static_cast<unsigned char>(v.idx() % 200)));
    SweepDecimaterT<RichMesh> decimater(mesh);
    ModVertexDistanceT<RichMesh>::Handle ivdd;
    decimater.add(ivdd);
    decimater.module(ivdd).set_max_distance(distance);
    REQUIRE(decimater.initialize());
    REQUIRE(decimater.decimate() > 0);
  }
  RichMesh mesh;
  OpenMesh::VPropHandleT<int> vertex_was;
  OpenMesh::HPropHandleT<int> halfedge_was;
  OpenMesh::EPropHandleT<int> edge_was;
  OpenMesh::FPropHandleT<int> face_was;
  OpenMesh::VPropHandleT<bool> tag;
};

}  // namespace

TEST_CASE("compaction leaves the surface that garbage collection leaves") {
  for (const IndexedMesh& in : {meshes::torus(24, 14), meshes::shaken(meshes::torus(30, 20), 0.01, 1)}) {
    Decimated a(in), b(in);
    compact(a.mesh);
    b.mesh.garbage_collection();
    CHECK(a.mesh.n_vertices() == b.mesh.n_vertices());
    CHECK(a.mesh.n_edges() == b.mesh.n_edges());
    CHECK(a.mesh.n_faces() == b.mesh.n_faces());
    CHECK(meshes::canonical(to_indexed(a.mesh)) == meshes::canonical(to_indexed(b.mesh)));
  }
}

TEST_CASE("compaction keeps the order, and every property stays with its element") {
  Decimated d(meshes::torus(24, 14));
  const RichMesh before = d.mesh;
  const Compaction map = compact(d.mesh);

  int last = -1;
  for (const auto v : d.mesh.vertices()) {
    const int was = d.mesh.property(d.vertex_was, v);
    CHECK(was > last);
    last = was;
    const RichMesh::VertexHandle old(was);
    CHECK(map.vertices[static_cast<std::size_t>(was)] == v.idx());
    CHECK(d.mesh.point(v) == before.point(old));
    CHECK(d.mesh.normal(v) == before.normal(old));
    CHECK(d.mesh.color(v) == before.color(old));
    CHECK(d.mesh.status(v).selected() == before.status(old).selected());
    CHECK(d.mesh.property(d.tag, v) == (was % 3 == 0));
  }
  last = -1;
  for (const auto f : d.mesh.faces()) {
    const int was = d.mesh.property(d.face_was, f);
    CHECK(was > last);
    last = was;
    CHECK(map.faces[static_cast<std::size_t>(was)] == f.idx());
    CHECK(d.mesh.normal(f) == before.normal(RichMesh::FaceHandle(was)));
  }
  for (const auto e : d.mesh.edges())
    CHECK(map.edges[static_cast<std::size_t>(d.mesh.property(d.edge_was, e))] == e.idx());
  for (const auto h : d.mesh.halfedges()) CHECK(map.halfedge(d.mesh.property(d.halfedge_was, h)) == h.idx());
  for (std::size_t v = 0; v < map.vertices.size(); ++v)
    CHECK((map.vertices[v] == -1) == before.status(RichMesh::VertexHandle(int(v))).deleted());
}

TEST_CASE("what is compacted is a sound half-edge mesh that can be worked on") {
  Decimated d(meshes::shaken(meshes::flat_grid(20), 0.2, 3), 1.1);
  compact(d.mesh);
  for (const auto h : d.mesh.halfedges()) {
    CHECK(d.mesh.next_halfedge_handle(d.mesh.prev_halfedge_handle(h)) == h);
    CHECK(d.mesh.from_vertex_handle(d.mesh.next_halfedge_handle(h)) == d.mesh.to_vertex_handle(h));
    if (!d.mesh.is_boundary(h))
      CHECK(d.mesh.face_handle(d.mesh.next_halfedge_handle(h)) == d.mesh.face_handle(h));
  }
  for (const auto v : d.mesh.vertices()) {
    CHECK(d.mesh.from_vertex_handle(d.mesh.halfedge_handle(v)) == v);
    if (d.mesh.is_boundary(v)) CHECK(d.mesh.is_boundary(d.mesh.halfedge_handle(v)));
  }
  SweepDecimaterT<RichMesh> again(d.mesh);
  ModVertexDistanceT<RichMesh>::Handle ivdd;
  again.add(ivdd);
  again.module(ivdd).set_max_distance(1.5);
  REQUIRE(again.initialize());
  CHECK(again.decimate() > 0);
}

TEST_CASE("compaction without anything deleted changes nothing, also without status") {
  auto mesh = fixture::to_openmesh<fixture::Mesh>(meshes::torus(8, 6));
  mesh.add_vertex({9, 9, 9});
  const auto before = to_indexed(mesh);
  const Compaction map = compact(mesh);
  const auto after = to_indexed(mesh);
  CHECK(after.points == before.points);
  CHECK(after.triangles == before.triangles);
  CHECK(map.vertices.back() == 48);
  fixture::Mesh empty;
  CHECK(compact(empty).vertices.empty());
}
