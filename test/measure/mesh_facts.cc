#include "measure/MeshFacts.hh"

#include <cmath>

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::measure;

TEST_CASE("facts of the empty mesh are all zero") {
  const MeshFacts f = facts({});
  CHECK(f.vertices == 0);
  CHECK(f.faces == 0);
  CHECK(f.edges == 0);
  CHECK(f.components == 0);
  CHECK(f.boundary_loops == 0);
  CHECK(f.euler_characteristic == 0);
  CHECK(f.min_edge == 0);
  CHECK(f.mean_edge == 0);
  CHECK(f.diagonal == 0);
  CHECK_FALSE(f.closed());
}

TEST_CASE("the facts of a single triangle are those of one face and one boundary loop") {
  const MeshFacts f = facts(single_triangle());
  CHECK(f.vertices == 3);
  CHECK(f.faces == 1);
  CHECK(f.edges == 3);
  CHECK(f.boundary_edges == 3);
  CHECK(f.boundary_loops == 1);
  CHECK(f.nonmanifold_edges == 0);
  CHECK(f.nonmanifold_vertices == 0);
  CHECK(f.isolated_vertices == 0);
  CHECK(f.degenerate_faces == 0);
  CHECK(f.components == 1);
  CHECK(f.euler_characteristic == 1);
  CHECK(f.area == 6);
  CHECK(f.volume == 0);
  CHECK(f.min_edge == 3);
  CHECK(f.max_edge == 5);
  CHECK(f.mean_edge == 4);
  CHECK(f.diagonal == 5);
  CHECK(f.box_min == Eigen::Vector3d(0, 0, 0));
  CHECK(f.box_max == Eigen::Vector3d(3, 4, 0));
  CHECK_FALSE(f.closed());
}

TEST_CASE("the facts of a tetrahedron are those of a closed surface") {
  const MeshFacts f = facts(tetrahedron());
  CHECK(f.edges == 6);
  CHECK(f.boundary_edges == 0);
  CHECK(f.boundary_loops == 0);
  CHECK(f.euler_characteristic == 2);
  CHECK(f.components == 1);
  CHECK(f.closed());
  CHECK(f.volume == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(f.area == Approx(1.5 + std::sqrt(3.0) / 2).epsilon(1e-14));
  CHECK(f.mean_edge == Approx((1 + std::sqrt(2.0)) / 2).epsilon(1e-14));

  IndexedMesh inside_out = tetrahedron();
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK(facts(inside_out).volume == Approx(-1.0 / 6).epsilon(1e-14));
  CHECK(facts(transformed(tetrahedron(), 1, {1e6, 1e6, 1e6})).volume == Approx(1.0 / 6).epsilon(1e-8));
}

TEST_CASE("two separate tetrahedra are two components") {
  IndexedMesh mesh = tetrahedron();
  append(mesh, transformed(tetrahedron(), 1, {5, 0, 0}));
  const MeshFacts f = facts(mesh);
  CHECK(f.components == 2);
  CHECK(f.euler_characteristic == 4);
  CHECK(f.closed());
  CHECK(f.volume == Approx(1.0 / 3).epsilon(1e-14));
}

TEST_CASE("two tetrahedra on a common vertex are two components and two fans") {
  IndexedMesh mesh = tetrahedron();
  append(mesh, transformed(tetrahedron(), -1, {0, 0, 0}));
  for (auto& t : mesh.triangles) {
    for (auto& vertex : t) vertex = vertex == 4 ? 0 : vertex;
  }
  const MeshFacts f = facts(mesh);
  CHECK(f.components == 2);
  CHECK(f.nonmanifold_vertices == 1);
  CHECK(f.nonmanifold_edges == 0);
  CHECK(f.isolated_vertices == 1);
  CHECK(f.euler_characteristic == 3);
}

TEST_CASE("the facts of an open grid count its boundaries, whole and with a hole") {
  IndexedMesh mesh = grid(4);
  MeshFacts f = facts(mesh);
  CHECK(f.vertices == 25);
  CHECK(f.faces == 32);
  CHECK(f.edges == 56);
  CHECK(f.boundary_edges == 16);
  CHECK(f.boundary_loops == 1);
  CHECK(f.euler_characteristic == 1);
  CHECK(f.area == 16);
  CHECK(f.min_edge == 1);

  mesh.triangles.erase(mesh.triangles.begin() + 10, mesh.triangles.begin() + 12);  // the quad at (1, 1)
  f = facts(mesh);
  CHECK(f.boundary_edges == 20);
  CHECK(f.boundary_loops == 2);
  CHECK(f.euler_characteristic == 0);
  CHECK(f.nonmanifold_vertices == 0);
}

TEST_CASE("a bow-tie vertex has two fans and one chain of boundary edges") {
  const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  const MeshFacts f = facts(mesh);
  CHECK(f.nonmanifold_vertices == 1);
  CHECK(f.nonmanifold_edges == 0);
  CHECK(f.components == 2);
  CHECK(f.boundary_loops == 1);
  CHECK(f.boundary_edges == 6);
}

TEST_CASE("an edge of three faces is non-manifold") {
  const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                         {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const MeshFacts f = facts(mesh);
  CHECK(f.edges == 7);
  CHECK(f.nonmanifold_edges == 1);
  CHECK(f.boundary_edges == 6);
  CHECK(f.nonmanifold_vertices == 0);
  CHECK(f.components == 1);
  CHECK_FALSE(f.closed());
}

TEST_CASE("a neighbour of the other direction makes the edge non-manifold") {
  IndexedMesh mesh = square(0, 0);
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  const MeshFacts f = facts(mesh);
  CHECK(f.nonmanifold_edges == 1);
  CHECK(f.boundary_edges == 4);
  CHECK(f.nonmanifold_vertices == 0);
  CHECK(facts(square(0, 0)).nonmanifold_edges == 0);
}

TEST_CASE("duplicate faces are found in any order of their vertices") {
  IndexedMesh mesh = single_triangle();
  mesh.triangles.push_back({1, 2, 0});
  mesh.triangles.push_back({2, 1, 0});
  const MeshFacts f = facts(mesh);
  CHECK(f.duplicate_faces == 2);
  CHECK(f.faces == 3);
  CHECK(f.edges == 3);
  CHECK(f.nonmanifold_edges == 3);
}

TEST_CASE("faces with a vertex twice, without area or with coincident points are degenerate") {
  IndexedMesh mesh = single_triangle();
  mesh.points.insert(mesh.points.end(), {{6, 0, 0}, {0, 0, 0}, {1, 1e-13, 0}});
  mesh.triangles.push_back({0, 1, 1});  // takes no part in the connections
  MeshFacts f = facts(mesh);
  CHECK(f.faces == 2);
  CHECK(f.degenerate_faces == 1);
  CHECK(f.edges == 3);
  CHECK(f.boundary_edges == 3);
  CHECK(f.isolated_vertices == 3);
  CHECK(f.euler_characteristic == 1);

  mesh.triangles.push_back({0, 1, 3});  // on one line
  mesh.triangles.push_back({0, 4, 1});  // 0 and 4 coincide
  mesh.triangles.push_back({0, 1, 5});  // a needle
  f = facts(mesh);
  CHECK(f.degenerate_faces == 4);
  CHECK(f.min_edge == 0);
  CHECK(f.area == Approx(6));

  const MeshFacts only_collapsed = facts({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 1, 1}}});
  CHECK(only_collapsed.degenerate_faces == 2);
  CHECK(only_collapsed.isolated_vertices == 2);
  CHECK(only_collapsed.duplicate_faces == 0);
  CHECK_FALSE(only_collapsed.closed());
}

TEST_CASE("degenerate faces do not depend on the scale") {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    CHECK(facts(transformed(single_triangle(), scale, {0, 0, 0})).degenerate_faces == 0);
  }
}

TEST_CASE("the Euler characteristic leaves out isolated vertices") {
  IndexedMesh mesh = tetrahedron();
  mesh.points.emplace_back(0, 0, 9);
  const MeshFacts f = facts(mesh);
  CHECK(f.vertices == 5);
  CHECK(f.isolated_vertices == 1);
  CHECK(f.euler_characteristic == 2);
  CHECK(f.box_max.z() == 9);
}

TEST_CASE("a torus has the Euler characteristic 0") {
  const MeshFacts f = facts(torus(96, 48));
  CHECK(f.euler_characteristic == 0);
  CHECK(f.closed());
  CHECK(f.components == 1);
  CHECK(f.nonmanifold_vertices == 0);
  const double pi = 3.14159265358979;
  CHECK(f.volume == Approx(4 * pi * pi).epsilon(0.01));
  CHECK(f.area == Approx(8 * pi * pi).epsilon(0.01));
}
