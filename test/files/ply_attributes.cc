/// \file
/// PLY's attributes.
#include <algorithm>

#include "files/bytes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

std::string header(const std::string& elements, const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

/// One vertex with these properties and values.
std::string vertex(const std::string& properties, const std::string& values) {
  return header("element vertex 1\n" + xyz + properties) + "0 0 0 " + values + "\n";
}

TEST_CASE("PLY: normals, colours and texture coordinates by their names") {
  const Folder folder;
  const auto attributes = [&](const std::string& properties, const std::string& values) {
    return folder.read("a.ply", vertex(properties, values)).attributes;
  };
  const Attributes normal =
      attributes("property float nz\nproperty float nx\nproperty float ny\n", "0.8 0 0.6");
  REQUIRE(normal.size() == 1);
  CHECK(normal[0].kind == Kind::normal);
  CHECK(normal[0].values == std::vector<float>{0, 0.6F, 0.8F});

  const Attributes bytes =
      attributes("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
                 "0 51 255 300");
  REQUIRE(bytes.size() == 1);
  CHECK(bytes[0].bytes);
  CHECK(bytes[0].values == std::vector<float>{0, 0.2F, 1, 1});

  const Attributes floats = attributes("property float r\nproperty float g\nproperty float b\n", "0.1 0.2 2");
  REQUIRE(floats.size() == 1);
  CHECK_FALSE(floats[0].bytes);
  CHECK(floats[0].values == std::vector<float>{0.1F, 0.2F, 2});

  const Attributes shorts =
      attributes("property ushort diffuse_red\nproperty ushort diffuse_green\nproperty ushort diffuse_blue\n",
                 "0 65535 1");
  REQUIRE(shorts.size() == 1);
  CHECK_FALSE(shorts[0].bytes);
  CHECK(shorts[0].values == std::vector<float>{0, 1, 1 / 65535.0F});

  for (const auto& [u, v] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
    const Attributes texture =
        attributes(std::string("property float ") + u + "\nproperty float " + v + "\n", "0.25 0.5");
    REQUIRE(texture.size() == 1);
    CHECK(texture[0].kind == Kind::texture);
    CHECK(texture[0].values == std::vector<float>{0.25F, 0.5F});
  }
}

TEST_CASE("PLY: other properties of vertices are scalars of their name") {
  const Folder folder;
  const MeshFile file = folder.read(
      "a.ply", vertex("property float quality\nproperty uchar label\nproperty int id\nproperty double exact\n"
                      "property float u\nproperty list uchar int l\n",
                      "nan 200 16777217 0.1 7 1 5"));
  REQUIRE(file.attributes.size() == 5);
  CHECK(std::isnan(find(file.attributes, Kind::scalar, "quality").values[0]));
  CHECK(find(file.attributes, Kind::scalar, "label").values[0] == 200);
  CHECK(find(file.attributes, Kind::scalar, "id").values[0] == 16777216);
  CHECK(find(file.attributes, Kind::scalar, "exact").values[0] == 0.1F);
  CHECK(find(file.attributes, Kind::scalar, "u").values[0] == 7);
  CHECK(file.report.rounded == Names{"property 'id'", "property 'exact'"});
  CHECK(file.report.notes() ==
        Names{"rounded to 32-bit floats: property 'id', property 'exact'", "not read: vertex property 'l'"});
}

TEST_CASE("PLY: texture coordinates of corners, as MeshLab writes them, along a fan") {
  const Folder folder;
  const std::string elements = "comment TextureFile a.png\nelement vertex 4\n" + xyz +
                               "property float s\nproperty float t\nelement face 2\n"
                               "property list uchar float texcoord\nproperty list uchar int vertex_indices\n"
                               "property int texnumber\n";
  const std::string vertices = "0 0 0 9 9\n1 0 0 9 9\n1 1 0 9 9\n0 1 0 9 9\n";
  const MeshFile file = folder.read(
      "a.ply", header(elements) + vertices + "8 0 0 1 0 1 1 0 1 4 0 1 2 3 0\n6 0.5 0.5 0 0 1 1 3 0 2 1 0\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 1}});
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].corners == Triangles{{0, 1, 2}, {0, 2, 3}, {4, 0, 2}});
  CHECK(file.attributes[0].values == std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1, 0.5F, 0.5F});
  CHECK(file.report.ignored == Names{"texture coordinates of vertices, as the faces have some"});
  CHECK(file.report.not_found == std::set<std::string>{"a.png"});

  const MeshFile some =
      folder.read("a.ply", header(elements) + vertices + "0 3 0 1 2 0\n6 0.5 0.5 0 0 1 1 3 0 2 3 0\n");
  CHECK(some.report.missing_values == 3);
  CHECK(some.attributes[0].corners == Triangles{{0, 0, 0}, {1, 0, 2}});
  CHECK(folder.error("a.ply", header(elements) + vertices + "5 1 2 3 4 5 3 0 1 2 0\n0 3 0 1 2 0\n") ==
        "a.ply:19: a face of 3 corners has 5 numbers of texture coordinates");
}

TEST_CASE("PLY: attributes in either byte order") {
  const Folder folder;
  for (const bool little : {true, false}) {
    std::string bytes = header("element vertex 1\nproperty uchar red\n" + xyz +
                                   "property uchar green\nproperty ushort blue\nproperty double weight\n",
                               little ? "binary_little_endian" : "binary_big_endian");
    const auto append = [&](auto value) {
      std::string part;
      append_little(part, value);
      if (!little) std::reverse(part.begin(), part.end());
      bytes += part;
    };
    append(std::uint8_t{255});
    for (const float coordinate : {1.0F, 2.0F, 3.0F}) append(coordinate);
    append(std::uint8_t{0});
    append(std::uint16_t{65535});
    append(0.5);
    const MeshFile file = folder.read("a.ply", bytes);
    CHECK(file.mesh.points[0] == IndexedMesh::Point(1, 2, 3));
    CHECK(find(file.attributes, Kind::colour).values == std::vector<float>{1, 0, 1});
    CHECK(find(file.attributes, Kind::scalar, "weight").values == std::vector<float>{0.5F});
    CHECK(file.report.notes().empty());
  }
}

TEST_CASE("PLY: attributes as written") {
  const Folder folder;
  Attribute colour = square_colours(true, false);
  const MeshFile back = folder.there_and_back(
      "a.ply", square(), {square_normals(), colour, square_texture(), scalar("quality", {1, 2, 3, 4.5F})},
      {true, true});
  CHECK(folder.get("a.ply") ==
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\nproperty float t\n"
        "property float quality\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 1 0 17 34 0 0.1 1\n1 0 0 0 0.6 0.8 51 68 85 1 0.25 2\n"
        "1 1 0 1 0 0 102 119 136 1 0.7 3\n0 1 0.5 -0.36 0.48 0.8 153 170 187 0.3 1 4.5\n"
        "3 0 1 2\n3 0 2 3\n");
  CHECK(back.attributes.size() == 4);
  write_mesh(folder / "b.ply", square(), {true, true}, {square_seam()});
  CHECK(folder.get("b.ply").find("property list uchar float texcoord\nend_header\n") != std::string::npos);
  CHECK(folder.get("b.ply").find("\n3 0 1 2 6 0 0.1 1 0.25 1 0.7\n") != std::string::npos);
}

TEST_CASE("PLY: scalars whose names cannot stand in a header are left out") {
  const Folder folder;
  const std::vector<float> values{1, 2, 3, 4};
  const WriteReport report = write_mesh(
      folder / "a.ply", square(), {},
      {scalar("two words", values), scalar("", values), scalar("x", values), scalar("good", values),
       scalar("good", values), scalar("red", values), scalar("alpha", values), square_colours(true, false)});
  CHECK(report.left_out == Names{"property 'two words'", "property ''", "property 'x'", "property 'good'",
                                 "property 'red'", "property 'alpha'"});
  CHECK(report.notes()[0].find("not written: property 'two words', ") == 0);
  const MeshFile back = read_mesh(folder / "a.ply");
  CHECK(back.attributes.size() == 2);
}

}  // namespace
}  // namespace whittle::files
