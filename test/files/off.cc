/// \file
/// OFF, rule by rule.
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST_CASE("OFF: counts on the next line, on the header line, glued to it, without edges") {
  const Folder folder;
  for (const char* header : {"OFF\n3 1 0\n", "OFF 3 1 3\n", "OFF3 1 0\n", "OFF\r\n3 1\r\n"}) {
    const MeshFile file = folder.read("a.off", header + body);
    CHECK(file.mesh.points[1] == IndexedMesh::Point(1, 0, 0));
    CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
    CHECK(file.report.format == "OFF");
    CHECK(file.report.notes().empty());
    CHECK_FALSE(file.single_precision);
  }
}

TEST_CASE("OFF: comments may stand anywhere") {
  const Folder folder;
  const MeshFile file = folder.read("a.off",
                                    "# first\n\nOFF # here\n# there\n3 1 0#\n\n0 0 0 # one\n1 0 0\n#\n0 1 0\n"
                                    "3 0 1 2# last\n# end\n\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(file.report.notes().empty());
}

TEST_CASE("OFF: polygons become fans, degenerate triangles go") {
  const Folder folder;
  const MeshFile file = folder.read("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 0 1\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(file.report.polygons == 1);
  CHECK(file.report.dropped_degenerate == 1);
}

TEST_CASE("OFF: told by its content whatever its extension") {
  const Folder folder;
  CHECK(folder.read("a.obj", "# c\nOFF 3 1 0\n" + body).report.format == "OFF");
  CHECK(folder.read("a", "OFF 3 1 0\n" + body).report.format == "OFF");
  CHECK(folder.error("a.off", body) == "a.off:1: not an OFF file: the first word is not OFF");
  CHECK(folder.error("a.off", "OFFICE\n") == "a.off:1: not an OFF file: the first word is not OFF");
}

TEST_CASE("OFF: errors name the line") {
  const Folder folder;
  const auto error = [&](const std::string& text) { return folder.error("a.off", text); };
  CHECK(error("OFF BINARY\n\1\2\3") == "a.off:1: binary OFF is not supported");
  CHECK(error("4OFF\n3 1 0\n" + body) == "a.off:1: OFF with other than three coordinates is not supported");
  CHECK(error("nOFF\n3\n3 1 0\n" + body) ==
        "a.off:1: OFF with other than three coordinates is not supported");
  CHECK(error("OFF\n") == "a.off:1: the file is cut off");
  CHECK(error("OFF\n3\n" + body) == "a.off:2: expected a count, found the end of the line");
  CHECK(error("OFF\n-3 1 0\n" + body) == "a.off:2: expected a count, found '-3'");
  CHECK(error("OFF\n3 1 0 7\n" + body) == "a.off:2: unexpected '7'");
  CHECK(error("OFF\n3 2 0\n" + body) == "a.off:6: the file is cut off");
  CHECK(error("OFF\n3 0 0\n" + body) == "a.off:6: there is more in the file than its counts say");
  CHECK(error("OFF\n99 1 0\n" + body) ==
        "a.off:2: the file is cut off: 99 vertices do not fit in the 27 bytes left");
  CHECK(error("OFF\n3 99 0\n" + body) ==
        "a.off:2: the file is cut off: 99 faces do not fit in the 27 bytes left");
  CHECK(error("OFF\n3 18446744073709551615 0\n" + body).find("a.off:2: the file is cut off") == 0);
  CHECK(error("OFF\n1 1 0\n0 0 x\n3 0 0 0\n") == "a.off:3: expected a number, found 'x'");
  CHECK(error("OFF\n1 1 0\n0 0 nan\n3 0 0 0\n") == "a.off:3: a coordinate is not finite");
  CHECK(error("OFF\n1 1 0\n0 0 0\n3 0 0 1\n") ==
        "a.off:4: vertex index 1 is out of range: there are 1 vertices");
  CHECK(error("OFF\n1 1 0\n0 0 0\n3 0 0 -1\n") ==
        "a.off:4: vertex index -1 is out of range: there are 1 vertices");
  CHECK(error("OFF\n1 1 0\n0 0 0\n2 0 0  \n") == "a.off:4: a face has fewer than three vertices");
  CHECK(error("OFF\n1 1 0\n0 0 0\n4294967295 0 0 0\n") ==
        "a.off:4: expected an integer, found the end of the line");
}

TEST_CASE("OFF: meshes are written with counts, points and faces as expected") {
  const Folder folder;
  IndexedMesh mesh;
  mesh.points = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  write_mesh(folder / "a.off", mesh);
  CHECK(folder.get("a.off") == "OFF\n3 1 0\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

}  // namespace
}  // namespace whittle::files
