#include "whittle/openmesh/FaceAdderT.hh"

#include <OpenMesh/Core/System/omstream.hh>
#include <random>

#include "OpenMeshFixture.hh"
#include "connectivity.hh"

using namespace whittle;
using fixture::Mesh;
using meshes::IndexedMesh;

namespace {

/// As OpenMesh builds it, and as the adder does; both take the same faces.
std::size_t require_as_openmesh(const IndexedMesh& in) {
  Mesh theirs, ours;
  for (const auto& p : in.points) {
    theirs.add_vertex(Mesh::Point(p[0], p[1], p[2]));
    ours.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  }
  ::omerr().disable();
  detail::FaceAdderT<Mesh> adder(ours);
  for (const auto& t : in.triangles) {
    const auto v = [&](std::size_t i) { return Mesh::VertexHandle(static_cast<int>(t[i])); };
    const bool is_degenerate = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    const auto expected = is_degenerate ? Mesh::FaceHandle() : theirs.add_face(v(0), v(1), v(2));
    REQUIRE(adder.add({v(0), v(1), v(2)}) == expected);
  }
  ::omerr().enable();
  for (Mesh* mesh : {&theirs, &ours}) {
    mesh->request_vertex_status();
    mesh->request_edge_status();
    mesh->request_face_status();
  }
  REQUIRE(ours.n_edges() == theirs.n_edges());
  fixture::require_same_connectivity(theirs, ours);
  return ours.n_faces();
}

}  // namespace

TEST_CASE("FaceAdderT builds what add_face builds, from faces in any order") {
  for (IndexedMesh mesh : {meshes::torus(8, 6), meshes::flat_grid(6), meshes::strip(7, 1.0),
                           meshes::octahedron(), meshes::cone(9, 1.0)}) {
    std::mt19937 random(1);
    for (int round = 0; round < 20; ++round) {
      CHECK(require_as_openmesh(mesh) > 0);
      std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    }
  }
}

TEST_CASE("FaceAdderT refuses what add_face refuses, and links what it takes alike, where faces are random") {
  std::size_t taken = 0, all = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const std::uint32_t n = 4 + seed % 9;
    const auto vertex = [&] { return static_cast<std::uint32_t>(random() % n); };
    IndexedMesh mesh;
    for (std::uint32_t v = 0; v < n; ++v) mesh.points.emplace_back(v, 0, 0);
    for (std::uint32_t f = 0; f < 3 * n; ++f) mesh.triangles.push_back({vertex(), vertex(), vertex()});
    taken += require_as_openmesh(mesh);
    all += mesh.triangles.size();
  }
  CHECK(taken > all / 10);
  CHECK(taken < all);
}
