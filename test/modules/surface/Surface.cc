#include "whittle/surface/Surface.hh"

#include <limits>

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using meshes::IndexedMesh;
using Surface = SurfaceT<double>;

TEST_CASE("a vertex inside is free, one on an open edge is boundary") {
  const IndexedMesh mesh = meshes::cone(6, 0.1);
  const Surface surface(mesh);
  CHECK(surface.is_free(0));
  for (std::uint32_t v = 1; v <= 6; ++v) CHECK(surface.flags(v) == kBoundary);
}

TEST_CASE("every vertex of a closed mesh is free") {
  for (const IndexedMesh& mesh : {meshes::tetrahedron(), meshes::octahedron(), meshes::torus(8, 6)}) {
    const Surface surface(mesh);
    for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) CHECK(surface.is_free(v));
  }
}

TEST_CASE("a vertex without faces is isolated") {
  IndexedMesh mesh = meshes::tetrahedron();
  mesh.points.emplace_back(5, 5, 5);
  CHECK(Surface(mesh).flags(4) == kIsolated);
}

TEST_CASE("what is not one fan is complex") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  SECTION("two fans that meet in a vertex") {
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    const Surface surface(mesh);
    CHECK(surface.is_complex(0));
    CHECK(surface.flags(1) == kBoundary);
  }
  SECTION("three faces on an edge") {
    mesh.triangles = {{0, 1, 2}, {0, 1, 5}, {1, 0, 4}};
    CHECK(Surface(mesh).is_complex(0));
    CHECK(Surface(mesh).is_complex(1));
  }
  SECTION("two neighbours that disagree about the direction") {
    mesh.triangles = {{0, 1, 2}, {0, 1, 4}};
    CHECK(Surface(mesh).is_complex(0));
  }
  SECTION("a face that names a vertex twice") {
    mesh.triangles = {{0, 1, 2}, {0, 2, 2}};
    CHECK(Surface(mesh).is_complex(0));
    CHECK(Surface(mesh).is_complex(2));
    CHECK(Surface(mesh).flags(1) == kBoundary);
  }
  SECTION("two closed fans that meet in a vertex") {
    mesh = meshes::tetrahedron();
    const IndexedMesh second = meshes::tetrahedron();
    for (int i = 1; i < 4; ++i) mesh.points.push_back(-second.points[i]);
    for (const auto& t : second.triangles) {
      const auto moved = [](std::uint32_t v) { return v == 0 ? 0 : v + 3; };
      mesh.triangles.push_back({moved(t[0]), moved(t[2]), moved(t[1])});
    }
    CHECK(Surface(mesh).is_complex(0));
    CHECK(Surface(mesh).is_free(1));
  }
}

TEST_CASE("the user's flags are kept beside the mesh's") {
  const IndexedMesh mesh = meshes::cone(6, 0.1);
  std::vector<std::uint8_t> flags(7, 0);
  flags[0] = kLocked;
  flags[1] = kFeature;
  const Surface surface(mesh, {flags, {}, {}});
  CHECK(surface.flags(0) == kLocked);
  CHECK(surface.flags(1) == (kFeature | kBoundary));
}

TEST_CASE("a vertex on a seam stays") {
  const IndexedMesh mesh = meshes::cone(6, 0.1);
  const Surface surface(mesh, {{kSeam, kSeam, 0, 0, 0, 0, 0}, {}, {}});
  CHECK(surface.flags(0) == kSeam);
  CHECK_FALSE(surface.is_free(0));
  CHECK(surface.flags(1) == (kSeam | kBoundary));
  CHECK_FALSE(surface.is_free(1, Boundary::merge));
}

TEST_CASE("boundary vertices may merge with one another, if that is asked for and nothing else holds them") {
  const IndexedMesh mesh = meshes::flat_grid(4);  // 5, 6, 9 and 10 are inside
  std::vector<std::uint8_t> flags(16, 0);
  flags[2] = flags[9] = kLocked;
  const Surface surface(mesh, {flags, {}, {}});
  CHECK_FALSE(surface.is_free(0));
  CHECK(surface.is_free(0, Boundary::merge));
  CHECK_FALSE(surface.is_free(2, Boundary::merge));
  CHECK(surface.is_free(5, Boundary::merge));

  for (const Boundary boundary : {Boundary::keep, Boundary::merge}) {
    CHECK(surface.may_merge(5, 6, boundary));
    CHECK_FALSE(surface.may_merge(5, 9, boundary));  // locked
    CHECK_FALSE(surface.may_merge(1, 5, boundary));  // in and out
    CHECK_FALSE(surface.may_merge(5, 1, boundary));
    CHECK_FALSE(surface.may_merge(1, 2, boundary));  // locked
    CHECK(surface.may_merge(0, 1, boundary) == (boundary == Boundary::merge));
  }
}

TEST_CASE("tolerances are 1 unless given, and 0 locks") {
  const IndexedMesh mesh = meshes::cone(6, 0.1);
  CHECK(Surface(mesh).tolerance(3) == 1);
  const Surface surface(mesh, {{}, {0, 0, 1, 2, 0.5f, 1e-30f, 1}, {}});
  CHECK(surface.flags(0) == kLocked);
  CHECK(surface.flags(1) == (kLocked | kBoundary));
  CHECK(surface.flags(5) == kBoundary);
  CHECK(surface.tolerance(3) == 2);
  CHECK(surface.tolerance(4) == 0.5);
}

TEST_CASE("a tolerance that means nothing is refused by name") {
  const IndexedMesh mesh = meshes::tetrahedron();
  using Limits = std::numeric_limits<float>;
  for (const float tolerance : {-1.f, -1e-30f, Limits::quiet_NaN(), Limits::infinity()}) {
    CHECK_THROWS_AS(Surface(mesh, {{}, {1, 1, tolerance, 1}, {}}), InvalidParameter);
    CHECK_THROWS_WITH(Surface(mesh, {{}, {1, 1, tolerance, 1}, {}}),
                      "vertex 2 has a tolerance that is negative or not finite");
  }
}

TEST_CASE("extras of another size than the mesh are refused") {
  const IndexedMesh mesh = meshes::cone(6, 0.1);  // 7 vertices, 6 faces
  const Eigen::Vector3d up(0, 0, 1);
  for (const std::size_t size : {1, 5, 6, 7, 8}) {
    INFO(size);
    const SurfaceExtras flags{std::vector<std::uint8_t>(size, 0), {}, {}},
        tolerance{{}, std::vector<float>(size, 1), {}},
        normals{{}, {}, std::vector<Eigen::Vector3d>(size, up)};
    if (size == 7) {
      CHECK_NOTHROW(Surface(mesh, flags));
      CHECK_NOTHROW(Surface(mesh, tolerance));
    } else {
      CHECK_THROWS_AS(Surface(mesh, flags), InvalidParameter);
      CHECK_THROWS_AS(Surface(mesh, tolerance), InvalidParameter);
    }
    if (size == 6)
      CHECK_NOTHROW(Surface(mesh, normals));
    else
      CHECK_THROWS_AS(Surface(mesh, normals), InvalidParameter);
  }
  CHECK_THROWS_AS(Surface(IndexedMesh(), SurfaceExtras{{0}, {}, {}}), InvalidParameter);
}

TEST_CASE("a face is judged by its own normal unless another one is given") {
  const IndexedMesh mesh = meshes::tetrahedron();
  const Surface own(mesh);
  for (std::uint32_t f = 0; f < 4; ++f) CHECK(own.reference_normal(f) == own.normal(f));
  CHECK(own.normal(0) == Eigen::Vector3d(0, 0, -1));
  const Surface given(mesh, {{}, {}, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {0, 0, 0}}});
  CHECK(given.reference_normal(1) == Eigen::Vector3d(4, 5, 6));
  CHECK(given.reference_normal(3) == Eigen::Vector3d(0, 0, 0));
  CHECK(given.normal(0) == Eigen::Vector3d(0, 0, -1));
}

TEST_CASE("a broken mesh is refused by name") {
  IndexedMesh mesh = meshes::tetrahedron();
  SECTION("index out of range") {
    mesh.triangles[2][1] = 4;
    CHECK_THROWS_AS(Surface(mesh), InvalidMesh);
  }
  SECTION("not a number") {
    mesh.points[3][2] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(Surface(mesh), "vertex 3 has a coordinate that is not finite");
  }
  SECTION("beyond 1e100") {
    mesh.points[1][0] = -1e100;
    CHECK_NOTHROW(Surface(mesh));
    mesh.points[2][1] = -1.001e100;
    CHECK_THROWS_WITH(Surface(mesh),
                      "vertex 2 has a coordinate beyond 1e100, where areas overflow: scale the mesh down");
  }
  SECTION("infinite") {
    mesh.points[0][0] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(Surface(mesh), InvalidMesh);
  }
}

TEST_CASE("an empty mesh is a surface without vertices") {
  const IndexedMesh mesh;
  CHECK(Surface(mesh).n_vertices() == 0);
  CHECK(Surface(mesh).n_faces() == 0);
}

TEST_CASE("both ends of an edge are on a seam if its faces differ at either of them") {
  const IndexedMesh mesh = meshes::flat_grid(4);
  for (const std::uint32_t split :
       {0u, 5u}) {  // at one end of the edge 0 5, between the faces 0 1 5 and 0 5 4
    auto wedges = mesh.triangles;
    REQUIRE(wedges[1] == IndexedMesh::Triangle{0, 5, 4});
    wedges[1][split == 0 ? 0 : 1] = 100;
    const std::vector<bool> seams = on_seams(mesh.triangles, wedges, 16);
    CHECK(seams[0]);
    CHECK(seams[5]);
    CHECK(seams[15] == false);
    CHECK(seams[4] == (split == 5));  // that corner of the face differs along its other edge, too
  }
}
