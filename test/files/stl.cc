/// \file
/// STL, rule by rule.
#include "files/bytes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}

/// Binary, from nine coordinates a triangle.
std::string binary(const std::vector<float>& coordinates, const std::string& header = "",
                   std::uint16_t attribute = 0) {
  std::string bytes = header;
  bytes.resize(80);
  append_little(bytes, static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t i = 0; i < coordinates.size(); i += 9) {
    bytes.append(12, '\0');
    for (std::size_t k = 0; k < 9; ++k) append_little(bytes, coordinates[i + k]);
    append_little(bytes, attribute);
  }
  return bytes;
}

const std::vector<float> one_triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST_CASE("STL: text, where equal corners become one vertex, -0 equals 0") {
  const Folder folder;
  const MeshFile file = folder.read("a.stl", "solid a name\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                                                 facet("0 1 0", "1 0 -0.0", "0.1 1 1") + "endsolid a name\n");
  CHECK(file.mesh.points.size() == 4);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {2, 1, 3}});
  CHECK(file.mesh.points[3].x() == 0.1F);
  CHECK(file.report.format == "STL, ASCII");
  CHECK(file.report.merged_vertices == 2);
  CHECK(file.report.notes() == Names{"2 vertices joined with others at the same place"});
  CHECK(file.single_precision);
}

TEST_CASE("STL: text in capitals, with NaN normals, several solids, loops of four") {
  const Folder folder;
  std::string text =
      "SOLID\nFACET NORMAL nan -nan(ind) 0\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 1 1 0\n";
  text += "VERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID\n";
  const MeshFile file =
      folder.read("a.STL", text + "solid two\r\n" + facet("5 0 0", "6 0 0", "5 1 0") + "endsolid");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  CHECK(file.report.polygons == 1);
  CHECK(folder.read("a.stl", "solid nothing\nendsolid\n").mesh.points.empty());
}

TEST_CASE("STL: triangles with equal corners are dropped and counted") {
  const Folder folder;
  const MeshFile text = folder.read("a.stl", "solid\n" + facet("0 0 0", "1 0 0", "-0 0 0") + "endsolid\n");
  CHECK(text.mesh.triangles.empty());
  CHECK(text.report.dropped_degenerate == 1);
  const MeshFile bytes = folder.read("a.stl", binary({1, 2, 3, 1, 2, 3, 4, 5, 6}));
  CHECK(bytes.mesh.points.size() == 2);
  CHECK(bytes.report.dropped_degenerate == 1);
}

TEST_CASE("STL: a binary file is read") {
  const Folder folder;
  const MeshFile file = folder.read("a.stl", binary(one_triangle));
  CHECK(file.mesh.points[1] == IndexedMesh::Point(1, 0, 0));
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(file.report.format == "STL, binary");
  CHECK(file.report.notes().empty());
  CHECK(file.single_precision);
  CHECK(folder.read("a.stl", binary({})).mesh.triangles.empty());
}

TEST_CASE("STL: a binary file that begins with 'solid' is read as binary") {
  const Folder folder;
  CHECK(folder.read("a.stl", binary(one_triangle, "solid by someone")).report.format == "STL, binary");
  CHECK(folder.read("a.stl", binary(one_triangle, "solid" + std::string(75, ' '))).report.format ==
        "STL, binary");
  // Cut off, it is still no text: no line of "expected 'facet'".
  CHECK(
      folder.error("a.stl", binary(one_triangle, "solid by someone").substr(0, 130)) ==
      "a.stl: 1 triangles are declared, 0 are there: the file is cut off; --repair fix reads what is there");
}

TEST_CASE("STL: attributes and bytes behind the end are named") {
  const Folder folder;
  CHECK(folder.read("a.stl", binary(one_triangle, "", 7)).report.ignored == Names{"face attributes"});
  CHECK(folder.read("a.stl", binary(one_triangle) + "x").report.ignored ==
        Names{"bytes after the last triangle"});
}

TEST_CASE("STL: a count that is wrong is refused, and read to the end of the file with a repair") {
  const Folder folder;
  const std::vector<float> two{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  std::string few = binary(two), none = binary(two), many = binary(two).substr(0, 84 + 50 + 20);
  few.replace(80, 4, std::string("\1\0\0\0", 4));
  none.replace(80, 4, std::string(4, '\0'));
  CHECK(folder.error("a.stl", few) ==
        "a.stl: 1 triangles are declared, 2 are there; --repair fix reads what is there");
  const MeshFile file = folder.read("a.stl", few, Repair::fix);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {1, 3, 2}});
  CHECK(file.report.wrong_count == "1 triangles are declared, 2 are there");
  CHECK(folder.read("a.stl", none, Repair::fix).mesh.triangles.size() == 2);
  const MeshFile cut = folder.read("a.stl", many, Repair::fix);
  CHECK(cut.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(cut.report.notes() == Names{"2 triangles are declared, 1 are there: the file is cut off",
                                    "not read: bytes after the last triangle"});
}

TEST_CASE("STL: text that ends early is read to its last whole facet with a repair") {
  const Folder folder;
  const std::string whole = "solid a\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 0", "1 1 0", "0 1 0");
  // Cut off behind the first facet, anywhere; what is whole stays.
  const std::size_t first = whole.find("endfacet") + 9;
  for (std::size_t length = first; length < whole.size() - 9; length += 7) {
    CHECK(folder.error("a.stl", whole.substr(0, length)).find("--repair fix reads what is there") !=
          std::string::npos);
    const MeshFile file = folder.read("a.stl", whole.substr(0, length), Repair::fix);
    CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
    CHECK(file.mesh.points.size() == 3);
    CHECK(file.report.wrong_count == "the file is cut off: read to its last whole facet");
  }
  CHECK(folder.read("a.stl", whole, Repair::fix).mesh.triangles.size() == 2);
  // Nonsense in the middle is no early end.
  CHECK(folder.error("a.stl", whole + "facets\n" + whole, Repair::fix) ==
        "a.stl:16: expected 'facet', found 'facets'");
}

TEST_CASE("STL: damaged files are refused with a message") {
  const Folder folder;
  const auto error = [&](const std::string& text) { return folder.error("a.stl", text); };
  CHECK(error("hello") == "a.stl: the file is cut off: too short for an STL header");
  CHECK(
      error(binary(one_triangle).substr(0, 133)) ==
      "a.stl: 1 triangles are declared, 0 are there: the file is cut off; --repair fix reads what is there");
  std::string huge = binary(one_triangle);
  huge.replace(80, 4, "\xff\xff\xff\xff");
  CHECK(error(huge) ==
        "a.stl: 4294967295 triangles are declared, 1 are there: the file is cut off; --repair fix reads what "
        "is "
        "there");
  CHECK(error(binary({0, 0, 0, 1, 0, 0, 0, 1, std::nanf("")})) == "a.stl: a coordinate is not finite");
  CHECK(
      error("solid\n") ==
      "a.stl:1: expected 'facet', found the end of the file: the file is cut off; --repair fix reads what is "
      "there");
  CHECK(error("solid\nfacet normal 0 0\nloop\n") == "a.stl:3: expected 'outer', found 'loop'");
  CHECK(error("solid\n" + facet("0 0 0", "1 0 0", "0 1")) ==
        "a.stl:6: expected a number, found the end of the line");
  CHECK(error("solid\n" + facet("0 0 0", "1 0 0", "0 1 1e39")) == "a.stl:6: a coordinate is not finite");
  CHECK(error("solid\n" + facet("0 0 0", "1 0 0", "0 1 0 0")) == "a.stl:6: expected 'endloop', found '0'");
  CHECK(error("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 "
              "0\nendloop\nendfacet\nendsolid\n") == "a.stl:7: a face has fewer than three vertices");
  CHECK(error("solid\nendsolid\nmore\n") == "a.stl:3: expected 'solid', found 'more'");
}

TEST_CASE("STL: facets are written with their normals") {
  const Folder folder;
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 0.1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 1}};
  write_mesh(folder / "a.stl", mesh, {true, false});
  CHECK(folder.get("a.stl") ==
        "solid whittle\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0.1 0\nendloop\n"
        "endfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 2 0 "
        "0\nendloop\nendfacet\n"
        "endsolid whittle\n");
  write_mesh(folder / "b.stl", mesh);
  const std::string bytes = folder.get("b.stl");
  REQUIRE(bytes.size() == 84 + 2 * 50);
  CHECK(load<float>(bytes.data() + 84 + 8, ByteOrder::little) == 1.0F);
  CHECK(load<float>(bytes.data() + 84 + 40, ByteOrder::little) == 0.1F);
  CHECK(bytes.substr(0, 5) != "solid");
}

}  // namespace
}  // namespace whittle::files
