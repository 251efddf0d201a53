/// \file
/// Coordinates far from the origin, in formats of 32-bit floats.
#include "files/rounding.hh"
#include "gltf_samples.hh"
#include "meshes.hh"

namespace whittle::files {
namespace {

/// A torus in a country's coordinates, to the millimetre and finer.
IndexedMesh surveyed() {
  IndexedMesh mesh = meshes::torus(24, 16);
  for (IndexedMesh::Point& point : mesh.points) point += IndexedMesh::Point(500000.123, 4000000.456, 1200);
  return mesh;
}

double largest_difference(const IndexedMesh& a, const IndexedMesh& b) {
  double largest = 0;
  REQUIRE(a.points.size() == b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    largest = std::max(largest, (a.points[i] - b.points[i]).norm());
  return largest;
}

TEST_CASE("far from the origin: GLB counts from a node near the mesh") {
  const Folder folder;
  const IndexedMesh mesh = surveyed();
  CHECK(write_mesh(folder / "a.glb", mesh).notes().empty());
  const Json node = json_of(folder.get("a.glb"))["nodes"][0];
  CHECK(node["translation"] == Json{500000.0, 4000000.0, 1200.0});
  const MeshFile back = read_mesh(folder / "a.glb");
  CHECK_FALSE(back.single_precision);
  CHECK(largest_difference(mesh, back.mesh) < 1e-6);
  // Once there, written again it does not move.
  write_mesh(folder / "b.glb", back.mesh);
  CHECK(largest_difference(read_mesh(folder / "b.glb").mesh, back.mesh) == 0);
}

TEST_CASE("far from the origin: all levels of detail count from one place") {
  const Folder folder;
  IndexedMesh coarse = surveyed();
  coarse.triangles.resize(10);
  write_levels(folder / "a.glb", {{surveyed(), {}, {}, 0}, {coarse, {}, {}, 1}});
  const Json nodes = json_of(folder.get("a.glb"))["nodes"];
  CHECK(nodes[0]["translation"] == nodes[1]["translation"]);
}

TEST_CASE("far from the origin: STL says by how much it rounds, where it shows") {
  const Folder folder;
  const IndexedMesh mesh = surveyed();
  const std::vector<std::string> notes = write_mesh(folder / "a.stl", mesh).notes();
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("coordinates rounded to 32-bit floats, by up to 0.") == 0);
  CHECK(largest_rounding(mesh) == largest_difference(mesh, rounded(mesh)));
  CHECK(largest_rounding(mesh) > tolerable_rounding(mesh));
  for (const char* file : {"a.obj", "a.off", "a.ply", "a.om"})
    CHECK(write_mesh(folder / file, mesh).notes().empty());
}

TEST_CASE(
    "far from the origin: what rounds by less than a hundredth of the shortest edge is not worth a word") {
  const Folder folder;
  const IndexedMesh mesh = meshes::torus(24, 16);
  REQUIRE(largest_rounding(mesh) > 0);
  CHECK(write_mesh(folder / "a.stl", mesh).notes().empty());
  CHECK(write_mesh(folder / "a.glb", mesh).notes().empty());
  CHECK_FALSE(json_of(folder.get("a.glb"))["nodes"][0].contains("translation"));

  IndexedMesh edge;  // 2^24 + 1 is no float: it moves by 1
  edge.points = {{16777217, 0, 0}, {16777317, 0, 0}, {16777217, 1000, 0}};
  edge.triangles = {{0, 1, 2}};
  CHECK(largest_rounding(edge) == 1);
  CHECK(tolerable_rounding(edge) == 1);
  CHECK(write_mesh(folder / "a.stl", edge).notes().empty());
  edge.points[1].x() -= 2;
  CHECK(write_mesh(folder / "a.stl", edge).notes() ==
        Names{"coordinates rounded to 32-bit floats, by up to 1 units"});
}

}  // namespace
}  // namespace whittle::files
