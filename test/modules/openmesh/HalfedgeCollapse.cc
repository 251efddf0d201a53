#include "whittle/openmesh/HalfedgeCollapse.hh"

#include <random>

#include "OpenMeshFixture.hh"
#include "connectivity.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

/// OpenMesh's own test.
struct Legality : OpenMesh::Decimater::BaseDecimaterT<Mesh> {
  using Base = OpenMesh::Decimater::BaseDecimaterT<Mesh>;
  using Base::Base;
  bool operator()(Mesh::HalfedgeHandle h) { return is_collapse_legal(CollapseInfo(*mesh, h)); }
  explicit Legality(Mesh& m) : Base(m), mesh(&m) {}
  Mesh* mesh;
};

}  // namespace

TEST_CASE("half-edges collapse as OpenMesh collapses them, and just where it finds that legal") {
  using meshes::flat_grid, meshes::torus, meshes::strip;
  IndexedMesh fan = meshes::cone(100, 1.0);  // around a vertex on the boundary
  fan.triangles.erase(fan.triangles.begin() + 40);
  for (const auto& in : {torus(8, 6), flat_grid(8), strip(7, 1.0), meshes::octahedron(),
                         meshes::tetrahedron(), meshes::lone_triangle(), meshes::cone(5, 1.0), fan}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      Mesh theirs = fixture::with_status(in);
      std::mt19937 random(seed);
      for (const auto v : theirs.vertices()) {
        theirs.status(v).set_locked(seed > 2 && random() % 9 == 0);
        theirs.status(v).set_feature(seed > 4 && random() % 3 == 0);
      }
      for (const auto e : theirs.edges()) theirs.status(e).set_feature(seed > 4 && random() % 2 == 0);
      Mesh ours = theirs;
      Legality is_legal(theirs);
      detail::HalfedgeCollapseT<Mesh> connectivity(ours);

      for (bool any = true; any;) {
        std::vector<Mesh::HalfedgeHandle> legal;
        for (const auto h : ours.halfedges()) {
          const bool allowed = is_legal(h);
          REQUIRE(connectivity.is_legal(h) == allowed);
          REQUIRE(connectivity.find(ours.from_vertex_handle(h), ours.to_vertex_handle(h)) == h);
          if (allowed) legal.push_back(h);
        }
        any = !legal.empty();
        if (!any) break;
        const auto h = legal[random() % legal.size()];
        theirs.collapse(h);
        connectivity.collapse(h);
        fixture::require_same_connectivity(theirs, ours);
      }
    }
  }
}

TEST_CASE("vertices that share no edge have no half-edge between them") {
  Mesh mesh = fixture::with_status(meshes::octahedron());
  const detail::HalfedgeCollapseT<Mesh> connectivity(mesh);
  std::size_t found = 0;
  for (const auto a : mesh.vertices())
    for (const auto b : mesh.vertices()) {
      const auto h = connectivity.find(a, b);
      CHECK(h == mesh.find_halfedge(a, b));
      found += h.is_valid();
    }
  CHECK(found == 24);
  const auto lone = mesh.add_vertex({9, 9, 9});
  CHECK_FALSE(connectivity.find(lone, mesh.vertex_handle(0)).is_valid());
}
