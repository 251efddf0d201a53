/// \file
/// PLY, rule by rule.
#include <algorithm>

#include "files/bytes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corner_list = "property list uchar int vertex_indices\n";

std::string header(const std::string& elements, const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string plain = header("element vertex 3\n" + xyz + "element face 1\n" + corner_list);
const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// Appends in the given byte order.
template <typename T>
void append(std::string& to, T value, ByteOrder order) {
  const std::size_t begin = to.size();
  append_little(to, value);
  if (order == ByteOrder::big) std::reverse(to.begin() + static_cast<std::ptrdiff_t>(begin), to.end());
}

TEST_CASE("PLY: a text file is read") {
  const Folder folder;
  const MeshFile file = folder.read("a.ply", plain + triangle);
  CHECK(file.mesh.points[2] == IndexedMesh::Point(0, 1, 0));
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(file.report.format == "PLY, ASCII");
  CHECK(file.report.notes().empty());
  CHECK(file.single_precision);
}

TEST_CASE("PLY: single precision is what x, y and z are declared as") {
  const Folder folder;
  const auto read = [&](const std::string& x) {
    return folder.read(
        "a.ply", header("element vertex 1\nproperty " + x + " x\nproperty float32 y\nproperty float z\n") +
                     "0.1 0.1 0\n");
  };
  CHECK(read("float").single_precision);
  CHECK(read("float").mesh.points[0].x() == 0.1F);
  CHECK_FALSE(read("double").single_precision);
  CHECK(read("double").mesh.points[0] == IndexedMesh::Point(0.1, 0.1F, 0));
  CHECK_FALSE(read("float64").single_precision);
}

TEST_CASE("PLY: elements and properties in any order, unknown ones passed over") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.ply",
      header("comment made by hand\nobj_info nothing\nelement camera 1\nproperty float view\n"
             "property list int float lens\nelement nothing 0\nproperty int a\nelement empty 99999999999\n"
             "element face 1\nproperty uchar red\nproperty list uchar float l\n"
             "property list ushort uint vertex_index\nproperty int flags\n"
             "element vertex 3\nproperty float nx\nproperty list uchar int links\nproperty double z\n"
             "property uchar red\nproperty uchar alpha\nproperty double x\nproperty float quality\nproperty "
             "int s\n"
             "property double y\n") +
          "1 2 0.5 0.5\n9 2 .5 .5 3 0 1 2 -5\n"
          "0 0 3 255 255 1 0.5 0 2\n0 2 7 7 6 255 255 4 0.5 0 5\n\n0 1 7 9 255 255 7 nan 0 8\n");
  CHECK(file.mesh.points[0] == IndexedMesh::Point(1, 2, 3));
  CHECK(file.mesh.points[1] == IndexedMesh::Point(4, 5, 6));
  CHECK(file.mesh.points[2] == IndexedMesh::Point(7, 8, 9));
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(file.report.ignored == Names{"element 'camera'", "face colours", "face property 'l'",
                                     "face property 'flags'", "vertex property 'links'"});
  REQUIRE(file.attributes.size() == 5);
  CHECK(find(file.attributes, Kind::scalar, "nx").values == std::vector<float>{0, 0, 0});
  CHECK(find(file.attributes, Kind::scalar, "red").values == std::vector<float>{255, 255, 255});
  CHECK(find(file.attributes, Kind::scalar, "alpha").values == std::vector<float>{255, 255, 255});
  CHECK(std::isnan(find(file.attributes, Kind::scalar, "quality").values[2]));
  CHECK(find(file.attributes, Kind::scalar, "s").values == std::vector<float>{0, 0, 0});
}

TEST_CASE("PLY: binary in either byte order, with every type") {
  const Folder folder;
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    const bool little = order == ByteOrder::little;
    std::string bytes = header(
        "element vertex 3\nproperty short skip\nproperty list uint8 double more\nproperty double x\n"
        "property int8 y\nproperty uint16 z\nelement face 1\nproperty list int32 uint8 vertex_indices\n"
        "property float32 f\nproperty uint u\nelement tail 1\nproperty list uint int16 t\n",
        little ? "binary_little_endian" : "binary_big_endian");
    for (int i = 0; i < 3; ++i) {
      append(bytes, std::int16_t{-1}, order);
      append(bytes, static_cast<std::uint8_t>(i), order);
      for (int k = 0; k < i; ++k) append(bytes, 1e300, order);
      append(bytes, 0.1 + i, order);
      append(bytes, static_cast<std::int8_t>(-i), order);
      append(bytes, static_cast<std::uint16_t>(60000 + i), order);
    }
    append(bytes, std::int32_t{3}, order);
    bytes += std::string("\0\1\2", 3);
    append(bytes, 1.0F, order);
    append(bytes, std::uint32_t{7}, order);
    append(bytes, std::uint32_t{2}, order);
    bytes += "abcd";

    const MeshFile file = folder.read("a.ply", bytes);
    CHECK(file.report.format == (little ? "PLY, binary little endian" : "PLY, binary big endian"));
    CHECK(file.mesh.points[0] == IndexedMesh::Point(0.1, 0, 60000));
    CHECK(file.mesh.points[2] == IndexedMesh::Point(2.1, -2, 60002));
    CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
    CHECK_FALSE(file.single_precision);
    CHECK(folder.read("a.ply", bytes + "\n").report.ignored.back() == "bytes after the last element");
    CHECK(folder.error("a.ply", bytes.substr(0, bytes.size() - 1)) == "a.ply: the file is cut off");
  }
}

TEST_CASE("PLY: every integer type names vertices") {
  const Folder folder;
  const auto check = [&](const std::string& type, auto zero) {
    std::string bytes =
        header(
            "element vertex 3\nproperty char x\nproperty char y\nproperty char z\nelement face 1\n"
            "property list char " +
                type + " vertex_indices\n",
            "binary_big_endian") +
        "\1\2\3\4\5\7\6\5\4\3";
    for (int i = 0; i < 3; ++i) append(bytes, static_cast<decltype(zero)>(i), ByteOrder::big);
    CHECK(folder.read("a.ply", bytes).mesh.triangles == Triangles{{0, 1, 2}});
  };
  check("char", std::int8_t{0});
  check("uchar", std::uint8_t{0});
  check("short", std::int16_t{0});
  check("ushort", std::uint16_t{0});
  check("int", std::int32_t{0});
  check("uint", std::uint32_t{0});
}

TEST_CASE("PLY: polygons become fans, degenerate triangles go") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.ply", header("element vertex 4\n" + xyz + "element face 2\n" + corner_list) +
                               "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + "4 0 1 2 3\n3 2 1 2\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(file.report.polygons == 1);
  CHECK(file.report.dropped_degenerate == 1);
}

TEST_CASE("PLY: DOS line ends in the header of a binary file, points alone") {
  const Folder folder;
  std::string dos;
  for (const char c : header("element vertex 1\n" + xyz, "binary_little_endian"))
    dos += c == '\n' ? "\r\n" : std::string(1, c);
  for (const float value : {10.0F, 13.0F, 32.0F}) append_little(dos, value);
  const MeshFile file = folder.read("a.ply", dos);
  CHECK(file.mesh.points == std::vector<IndexedMesh::Point>{{10, 13, 32}});
  CHECK(file.mesh.triangles.empty());
}

TEST_CASE("PLY: told by its content whatever its extension") {
  const Folder folder;
  CHECK(folder.read("a.stl", plain + triangle).report.format == "PLY, ASCII");
  CHECK(folder.error("a.ply", "plywood\n") == "a.ply:1: not a PLY file: the first line is not 'ply'");
}

TEST_CASE("PLY: errors in the header") {
  const Folder folder;
  const auto error = [&](const std::string& text) { return folder.error("a.ply", "ply\n" + text); };
  CHECK(error("") == "a.ply:1: the file is cut off: the header has no end_header");
  CHECK(error("format ascii 1.0\nelement fac") == "a.ply:3: expected a count, found the end of the file");
  CHECK(error("format ascii 1.0\nelement vertex 1\n") ==
        "a.ply:3: the file is cut off: the header has no end_header");
  CHECK(error("format ascii 1.0\nproperty float x\n") == "a.ply:3: a property before any element");
  CHECK(error("element vertex 0\nend_header\n") == "a.ply:3: the header has no format");
  CHECK(error("format ascii 1.0\nformat ascii 1.0\n") == "a.ply:3: a second format");
  CHECK(error("format text 1.0\n") == "a.ply:2: unknown format 'text'");
  CHECK(error("format ascii 2.0\n") == "a.ply:2: unknown version '2.0'");
  CHECK(error("format ascii 1.0 x\n") == "a.ply:2: unexpected 'x'");
  CHECK(error("format ascii 1.0\nelement vertex -1\n") == "a.ply:3: expected a count, found '-1'");
  CHECK(error("format ascii 1.0\nelement\n") == "a.ply:3: a name is missing");
  CHECK(error("format ascii 1.0\nelement a 1\nelement a 1\n") == "a.ply:4: a second element 'a'");
  CHECK(error("element a 1\nproperty int b\nproperty int b\n") == "a.ply:4: a second property 'b'");
  CHECK(error("element a 1\nproperty real b\n") == "a.ply:3: unknown type 'real'");
  CHECK(error("element a 1\nproperty int\n") == "a.ply:3: a name is missing");
  CHECK(error("element a 1\nproperty list float int b\n") ==
        "a.ply:3: the length of a list is not an integer");
  CHECK(error("hello\n") == "a.ply:2: unknown header line 'hello'");
  std::string many = "element a 1\n";
  for (int i = 0; i < 2000; ++i) many += "property int p" + std::to_string(i) + "\n";
  CHECK(error(many) == "a.ply:1002: the header has more than 1000 elements and properties");
}

TEST_CASE("PLY: errors in what is declared") {
  const Folder folder;
  const auto error = [&](const std::string& elements) {
    return folder.error("a.ply", header(elements) + triangle);
  };
  CHECK(error("") == "a.ply:3: the header has no element vertex");
  CHECK(error("element vertex 1\nproperty float x\nproperty float y\n") ==
        "a.ply:6: the vertices lack x, y or z");
  CHECK(error("element vertex 1\nproperty float x\nproperty float y\nproperty list int int z\n") ==
        "a.ply:7: the vertices lack x, y or z");
  CHECK(error("element vertex 3\n" + xyz + "element face 1\nproperty int vertex_indices\n") ==
        "a.ply:12: the faces have no list vertex_indices");
  CHECK(error("element vertex 3\n" + xyz + "element face 1\nproperty list int float vertex_indices\n") ==
        "a.ply:12: the vertex indices are not integers");
  CHECK(error("element vertex 100\n" + xyz) ==
        "a.ply:7: the file is cut off: 100 of element 'vertex' do not fit in the 27 bytes left");
  CHECK(error("element vertex 18446744073709551615\n" + xyz).find("a.ply:7: the file is cut off: 18446744") ==
        0);
  CHECK(error("element a 9999999999\nproperty int b\nelement vertex 0\n" + xyz)
            .find("a.ply:9: the file is cut off") == 0);
}

TEST_CASE("PLY: errors in a text body name the line") {
  const Folder folder;
  const auto error = [&](const std::string& body) { return folder.error("a.ply", plain + body); };
  CHECK(error("0 0 0\n1 0 0\n0 1\n3 0 1 2\n") == "a.ply:12: expected a number, found the end of the line");
  CHECK(error("0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n") == "a.ply:12: expected a number, found 'x'");
  CHECK(error("0 0 0\n1 0 inf\n0 0 0\n3 0 1 2\n") == "a.ply:11: a coordinate is not finite");
  CHECK(error("0 0 0\n1 0 1e39\n0 0 0\n3 0 1 2\n") == "a.ply:11: a coordinate is not finite");
  CHECK(error("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n") ==
        "a.ply:13: vertex index 3 is out of range: there are 3 vertices");
  CHECK(error("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n") ==
        "a.ply:13: vertex index -1 is out of range: there are 3 vertices");
  CHECK(error("0 0 0\n1 0 0\n0 1 0\n2 0 1   \n") == "a.ply:13: a face has fewer than three vertices");
  CHECK(error("0 0 0\n1 0 0\n0 1 0\n-1 0 1  \n") == "a.ply:13: a list of negative length");
  CHECK(error("0 0 0\n1 0 0\n0 1 0\n3000000000 0 1 2\n") ==
        "a.ply:13: expected an integer, found the end of the line");
  CHECK(error("0 0 0\n1 0 0\n0 1 0 \\\n       ") == "a.ply:13: the file is cut off");
  CHECK(error("0 0 0\n1 0 0\n0 1 0\n        ") == "a.ply:13: the file is cut off");
  CHECK(error(triangle + "3 0 1 2\n") == "a.ply:14: there is more in the file than its header declares");
}

TEST_CASE("PLY: huge lists in binary bodies") {
  const Folder folder;
  const std::string vertices(36, '\0');
  const auto error = [&](const std::string& face, const std::string& body) {
    return folder.error(
        "a.ply", header("element vertex 3\n" + xyz + "element face 1\n" + face, "binary_little_endian") +
                     vertices + body);
  };
  CHECK(error("property list uint int vertex_indices\n", "\xff\xff\xff\xff" + std::string(12, '\0')) ==
        "a.ply: the file is cut off");
  CHECK(error("property list uint double skip\nproperty list uchar int vertex_indices\n",
              "\xff\xff\xff\xff" + std::string(12, '\0')) == "a.ply: the file is cut off");
  CHECK(error("property list char int vertex_indices\n", "\xff" + std::string(12, '\0')) ==
        "a.ply: a list of negative length");
}

TEST_CASE("PLY: meshes are written header and body as expected") {
  const Folder folder;
  IndexedMesh mesh;
  mesh.points = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  write_mesh(folder / "t.ply", mesh, {true, false});
  CHECK(
      folder.get("t.ply") ==
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_mesh(folder / "b.ply", mesh, {false, true});
  const std::string bytes = folder.get("b.ply");
  const std::string expected_header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  REQUIRE(bytes.size() == expected_header.size() + 36 + 13);
  CHECK(bytes.substr(0, expected_header.size()) == expected_header);
  CHECK(bytes.substr(expected_header.size(), 4) == "\xcd\xcc\xcc\x3d");
  CHECK(bytes.substr(bytes.size() - 13) == std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
}

}  // namespace
}  // namespace whittle::files
