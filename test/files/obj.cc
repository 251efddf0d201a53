/// \file
/// OBJ, rule by rule.
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_CASE("OBJ: a triangle is read") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.obj", "# a comment\nv 0.1 -2e3 +.5\nv 1 0 0 # here too\nv 0 1 0\n\nf 1 2 3\n");
  REQUIRE(file.mesh.points.size() == 3);
  CHECK(file.mesh.points[0] == IndexedMesh::Point(0.1, -2000, 0.5));
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(file.report.format == "OBJ");
  CHECK(file.report.notes().empty());
  CHECK_FALSE(file.single_precision);
}

TEST_CASE("OBJ: corners are read in all four forms") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", three +
                                                 "vt 0.5 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\n"
                                                 "f 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\n");
  CHECK(file.mesh.triangles == Triangles(4, {0, 1, 2}));
  CHECK(file.report.ignored.empty());
  CHECK(file.report.missing_values == 12);  // two faces have no texture coordinates, two no normals
  REQUIRE(file.attributes.size() == 2);
  CHECK(file.attributes[0].values == std::vector<float>{0, 0, 0.5F, 0});
  CHECK(file.attributes[0].corners == Triangles{{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}});
  CHECK(file.attributes[1].values == std::vector<float>{0, 0, 0, 0, 0, 1});
}

TEST_CASE("OBJ: slashes of what is not there are passed over") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.obj",
      three + "f 1// 2// 3//\nf 1/ 2/ 3/\nf -3// -2/ -1//\nvt 0.5 0\nf 1/1/ 2/1/ 3/1/\nf 1//\\\n 2// 3//\n");
  CHECK(file.mesh.triangles == Triangles(5, {0, 1, 2}));
  CHECK(file.report.ignored.empty());
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].corners[3] == IndexedMesh::Triangle{1, 1, 1});
}

TEST_CASE("OBJ: negative indices count back from the last vertex read") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", three + "f -3 -2 -1\nv 5 5 5\nf -1 -2/7 -3\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {3, 2, 1}});
}

TEST_CASE("OBJ: a face may come before its vertices") {
  const Folder folder;
  CHECK(folder.read("a.obj", "f 1 2 3\n" + three).mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(folder.error("a.obj", "f 1 2 3\nf 2 9 3\nf 1 2 3\n" + three) ==
        "a.obj:2: vertex index 9 is out of range: there are 3 vertices");
}

TEST_CASE("OBJ: polygons become fans, degenerate triangles go") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.obj", three + "v 2 1 0\nv 1 2 0\nf 1 2 4 5 3\nf 1 1 2\nf 1 2 3 1\n", Repair::none);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 3}, {0, 3, 4}, {0, 4, 2}, {0, 1, 2}});
  CHECK(file.report.polygons == 2);
  CHECK(file.report.dropped_degenerate == 2);
  CHECK(file.report.notes() == Names{"2 faces with more than three corners split into triangles",
                                     "2 triangles that name a vertex twice left out"});
}

TEST_CASE("OBJ: continued lines, DOS line ends, a byte order mark, no last line end") {
  const Folder folder;
  CHECK(folder.read("a.obj", three + "f 1 \\\n2\\\n 3\n").mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(folder.read("a.obj", "v 0 0 0\r\nv 1 0 \\\r\n0\r\nv 0 1 0\r\nf 1 2 3").mesh.triangles ==
        Triangles{{0, 1, 2}});
  CHECK(folder.read("a.obj", "\xEF\xBB\xBF" + three + "f 1 2 3").mesh.triangles == Triangles{{0, 1, 2}});
  // A comment is not continued, another statement that is skipped is.
  CHECK(folder.read("a.obj", three + "# see \\\nf 1 2 3\ng a \\\nf 1 2 3\n").mesh.triangles.size() == 1);
}

TEST_CASE("OBJ: what is not read is named once") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj",
                                    "mtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 0 1 0 1\ng x\ns off\n"
                                    "usemtl red\nl 1 2\np 1\nvp 0 0\nlod 3\nvt 0 0 0.5\nvn 0 0 1\nf 1 2 3\n");
  CHECK(file.report.ignored == Names{"vertex weights", "lines", "points", "free-form geometry",
                                     "display settings", "depths of texture coordinates",
                                     "texture coordinates that no face uses", "normals that no face uses"});
  CHECK(file.report.notes() ==
        Names{"not read: vertex weights, lines, points, free-form geometry, display "
              "settings, depths of texture coordinates, texture coordinates that no face uses, normals that "
              "no face uses",
              "not found: a.mtl"});
}

TEST_CASE("OBJ: a mesh without faces is read") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", three);
  CHECK(file.mesh.points.size() == 3);
  CHECK(file.mesh.triangles.empty());
}

TEST_CASE("OBJ: tiny numbers become zero, huge ones are refused") {
  const Folder folder;
  CHECK(folder.read("a.obj", "v 1e-400 -1e-310 0\n").mesh.points[0] == IndexedMesh::Point(0, -1e-310, 0));
  CHECK(folder.error("a.obj", "v 1e400 0 0\n") == "a.obj:1: a coordinate is not finite");
  CHECK(folder.error("a.obj", "v 1e99999 0 0\n") == "a.obj:1: '1e99999' is out of range");
}

TEST_CASE("OBJ: errors name the line") {
  const Folder folder;
  const auto error = [&](const std::string& text) { return folder.error("a.obj", three + text); };
  CHECK(error("f 1 2\n") == "a.obj:4: a face has fewer than three vertices");
  CHECK(error("f\n") == "a.obj:4: a face has fewer than three vertices");
  CHECK(error("\n\nf 0 1 2\n") == "a.obj:6: vertex index 0: OBJ counts from 1");
  CHECK(error("f 1/1 2/1 9/1\n") == "a.obj:4: vertex index 9 is out of range: there are 3 vertices");
  CHECK(error("f 1 2 -4\n") == "a.obj:4: vertex index -4 is out of range: there are 3 vertices");
  CHECK(error("f 1 2 \\\nx\n") == "a.obj:5: expected an integer, found 'x'");
  CHECK(error("f 1 2 3.5\n") == "a.obj:4: expected an integer, found '3.5'");
  CHECK(error("f 1 2 3/\n").empty());
  CHECK(error("f 1 2 3/a\n") == "a.obj:4: expected an integer, found 'a'");
  CHECK(error("f 1 2 3//a\n") == "a.obj:4: expected an integer, found 'a'");
  CHECK(error("f 1 2 99999999999999999999\n") ==
        "a.obj:4: expected an integer, found '99999999999999999999'");
  CHECK(error("v 1 2\nv 0 0 0\n") == "a.obj:4: expected a number, found the end of the line");
  CHECK(error("v 1 2") == "a.obj:4: expected a number, found the end of the file");
  CHECK(error("v 1 2 3x\n") == "a.obj:4: expected a number, found '3x'");
  CHECK(error("v 1 2 +-3\n") == "a.obj:4: expected a number, found '+-3'");
  CHECK(error("v 1 2 nan\n") == "a.obj:4: a coordinate is not finite");
  CHECK(error("v 1 2 -inf\n") == "a.obj:4: a coordinate is not finite");
  CHECK(error("v 1 2 3 4 5\n") == "a.obj:4: a vertex has 5 numbers");
  CHECK(error("v 1 2 3 4 5 6 7 8 9\n") == "a.obj:4: a vertex has more than 8 numbers");
  CHECK(error("vt\n") == "a.obj:4: expected a number, found the end of the line");
  CHECK(error("vn 0 0\n") == "a.obj:4: expected a number, found the end of the line");
  CHECK(error("vt 0 0\nf 1/1 2/2 3/1\n") ==
        "a.obj:5: texture coordinate index 2 is out of range: there are 1 of them");
  CHECK(error("vn 0 0 1\nf 1//1 2//-2 3//1\n") ==
        "a.obj:5: normal index -2 is out of range: there are 1 of them");
  CHECK(error("vn 0 0 1\nf 1//1 2//0 3//1\n") == "a.obj:5: normal index 0: OBJ counts from 1");
  CHECK(error("v 1 2 3 red green blue\n") == "a.obj:4: expected a number, found 'red'");
  CHECK(error("hello\n") == "a.obj:4: unknown statement 'hello'");
  CHECK(error("\x01\x7f\xff\n") ==
        "a.obj:4: unknown statement '?"
        "?"
        "?'");
  CHECK(error(std::string(1000, 'x')) == "a.obj:4: unknown statement '" + std::string(40, 'x') + "...'");
}

TEST_CASE("OBJ: meshes are written line by line as expected") {
  const Folder folder;
  IndexedMesh mesh;
  mesh.points = {{0.1, -0.0, 1e300}, {1, 2, 3}, {1.0 / 3, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  write_mesh(folder / "a.obj", mesh);
  CHECK(folder.get("a.obj") == "v 0.1 -0 1e+300\nv 1 2 3\nv 0.3333333333333333 0 0\nf 1 2 3\n");
  mesh.points[0].z() = 0.1F;
  write_mesh(folder / "a.OBJ", mesh, {false, true});
  CHECK(folder.get("a.OBJ") == "v 0.1 -0 0.1\nv 1 2 3\nv 0.33333334 0 0\nf 1 2 3\n");
}

}  // namespace
}  // namespace whittle::files
