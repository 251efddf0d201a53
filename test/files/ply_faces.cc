/// \file
/// PLY's other ways to have faces, and what stands at them.
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string head = "ply\nformat ascii 1.0\n";
const std::string place_of = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list int int vertex_indices\nend_header\n";

std::string vertices(int n) {
  return "element vertex " + std::to_string(n) + "\n" + place_of;
}

/// Places (0, 0), (1, 0), (0, 1), (1, 1), (0, 2), …: a strip's.
std::string zigzag(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += std::to_string(i % 2) + " " + std::to_string(i / 2) + " 0\n";
  return text;
}

TEST_CASE("PLY: a strip of triangles turns each second one round") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.ply", head + vertices(6) + "element tristrips 1\n" + list + zigzag(6) + "6 0 1 2 3 4 5\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}});
  CHECK(file.report.notes().empty());
}

TEST_CASE("PLY: strips begin anew at -1, and leave out what has no area") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.ply", head + vertices(6) + "element tristrips 2\n" + list + zigzag(6) +
                               "9 -1 0 1 2 -1 1 3 2 4\n"  // two strips; the second begins unturned
                               "7 0 1 2 2 3 3 5\n");      // one that goes on elsewhere
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {0, 1, 2}});
  CHECK(file.report.dropped_degenerate == 4);
  CHECK(
      folder.error("a.ply", head + vertices(3) + "element tristrips 1\n" + list + zigzag(3) + "3 0 1 3\n") ==
      "a.ply:13: vertex index 3 is out of range: there are 3 vertices");
  CHECK(
      folder.error("a.ply", head + vertices(3) + "element tristrips 1\n" + list + zigzag(3) + "3 0 1 -2\n") ==
      "a.ply:13: vertex index -2 is out of range: there are 3 vertices");
}

TEST_CASE("PLY: fans of triangles, and strips beside faces") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.ply", head + vertices(4) + "element face 1\nproperty list uchar int vertex_indices\n" +
                   "element trifans 1\n" + list + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 3 2 1\n4 0 1 2 3\n");
  CHECK(file.mesh.triangles == Triangles{{3, 2, 1}, {0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("PLY: a range image gives the triangles between neighbours that are there") {
  const Folder folder;
  // Three columns, two rows; the cell in the upper right corner is empty.
  const std::string info = "obj_info num_cols 3\nobj_info num_rows 2\nobj_info echo_rgb_offset nothing\n";
  const std::string points = "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 5\n";
  const MeshFile file = folder.read("a.ply", head + info + vertices(5) + "element range_grid 6\n" + list +
                                                 points + "1 0\n1 1\n1 2\n1 3\n1 4\n0\n");
  // Counterclockwise with rows upwards; the first square along the shorter diagonal.
  CHECK(file.mesh.triangles == Triangles{{1, 4, 3}, {1, 3, 0}, {1, 2, 4}});
  CHECK(file.report.notes().empty());
  CHECK(folder.error("a.ply", head + vertices(1) + "element range_grid 1\n" + list + "0 0 0\n1 0\n") ==
        "a.ply:10: a range_grid without num_cols and num_rows in obj_info");
  CHECK(folder.error("a.ply", head + info + vertices(1) + "element range_grid 5\n" + list +
                                  "0 0 0\n0\n0\n0\n0\n0\n") ==
        "a.ply:13: the range_grid has 5 cells instead of 3 by 2");
  CHECK(folder
            .error("a.ply", head + info + vertices(5) + "element range_grid 6\n" + list + points +
                                "1 0\n2 1 2\n1 2\n1 3\n1 4\n0\n")
            .find("a cell of the range_grid with more than one vertex") != std::string::npos);
}

TEST_CASE("PLY: colours of faces go to their corners") {
  const Folder folder;
  const std::string face =
      "element face 2\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property list uchar int vertex_indices\nend_header\n";
  const MeshFile file =
      folder.read("a.ply", head + vertices(4) + face + zigzag(4) + "255 0 0 3 0 1 2\n0 51 0 3 2 1 3\n");
  REQUIRE(file.attributes.size() == 1);
  const Attribute& colour = file.attributes[0];
  CHECK(colour.kind == Kind::colour);
  CHECK(colour.bytes);
  CHECK(colour.values == std::vector<float>{1, 0, 0, 0, 0.2F, 0});
  CHECK(colour.corners == Triangles{{0, 0, 0}, {1, 1, 1}});
  CHECK(file.report.notes().empty());

  // Polygons too, floats as they are, with opacity.
  const MeshFile square = folder.read(
      "a.ply",
      head + vertices(4) +
          "element face 1\nproperty list uchar int vertex_indices\nproperty float red\nproperty float green\n"
          "property float blue\nproperty float alpha\nend_header\n"
          "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 0.5 0.25 1 0.75\n");
  REQUIRE(square.attributes.size() == 1);
  CHECK(square.attributes[0].per_vertex());
  CHECK(square.attributes[0].components == 4);
  CHECK_FALSE(square.attributes[0].bytes);
  CHECK(square.attributes[0].value(3)[1] == 0.25F);

  // Those of the vertices go before.
  const MeshFile both = folder.read(
      "a.ply", head + vertices(4) + "property uchar red\nproperty uchar green\nproperty uchar blue\n" + face +
                   "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n1 1 0 1 2 3\n9 9 9 3 0 1 2\n9 9 9 3 2 1 3\n");
  CHECK(both.attributes.size() == 1);
  CHECK(both.report.ignored == Names{"face colours, as the vertices have some"});
}

TEST_CASE("PLY: more values in a line than the header declares are passed over and counted") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.ply", head + vertices(4) + "element face 2\n" + list +
                               "0 0 0\n1 0 0 9 9\n0 1 0\n1 1 0\n3 0 1 2 255\n3 1 3 2 255 255\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {1, 3, 2}});
  CHECK(file.report.overlong_lines == 3);
  CHECK(file.report.notes() ==
        Names{"3 lines have more values than the header declares; the surplus is not read"});
}

TEST_CASE("PLY: polygons before their vertices are cut when those are there") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.ply",
      head + "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n" +
          vertices(4) + "end_header\n4 0 1 2 3 8 0 0 0.1 0 0.2 0 0.3 0\n4 0 0 1 2 8 0 0 0 0 0.1 0 0.2 0\n" +
          "0 0 0\n2 -1 0\n0.5 0 0\n2 1 0\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {3, 0, 2}, {0, 1, 2}});
  CHECK(file.report.concave_polygons == 1);
  CHECK(file.report.dropped_degenerate == 1);
  const Attribute& texture = find(file.attributes, Kind::texture);
  CHECK(texture.per_vertex());
  CHECK(texture.value(3)[0] == 0.3F);
}

}  // namespace
}  // namespace whittle::files
