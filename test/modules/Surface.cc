#include "whittle/Surface.hh"

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

TEST_CASE("the ring goes counter-clockwise and pairs faces with vertices") {
  const IndexedMesh mesh = meshes::grid(3, [](std::uint32_t, std::uint32_t) { return 0.0; });
  const Surface surface(mesh);
  RingWalk<double> walk(surface);

  const Ring closed = walk.around(4);
  REQUIRE(closed.shape == Ring::Shape::closed);
  REQUIRE(closed.vertices.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& t = mesh.triangles[closed.faces[i]];
    CHECK(std::set<std::uint32_t>(t.begin(), t.end()) ==
          std::set<std::uint32_t>{4, closed.vertices[i], closed.vertices[(i + 1) % 6]});
    const auto a = mesh.points[closed.vertices[i]] - mesh.points[4];
    const auto b = mesh.points[closed.vertices[(i + 1) % 6]] - mesh.points[4];
    CHECK(a.cross(b).z() > 0);
  }

  const Ring open = walk.around(1);
  CHECK(open.shape == Ring::Shape::open);
  CHECK(open.vertices == std::vector<std::uint32_t>{2, 5, 4, 0});
  CHECK(open.faces.size() == 3);
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
