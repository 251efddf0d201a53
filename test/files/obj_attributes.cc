/// \file
/// OBJ's attributes.
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_CASE("OBJ: corners that agree are stored per vertex") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", kCorners +
                                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0 0\nvn 0 0 1\n"
                                                 "f 1/1/1 2/2/1 3/3/1 4/4/1\nf 4/4/1 1/5/1 2/2/1\n");
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {3, 0, 1}});
  REQUIRE(file.attributes.size() == 2);
  CHECK(file.attributes[0].kind == Kind::texture);
  CHECK(file.attributes[0].per_vertex());
  CHECK(file.attributes[0].values == std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1});
  CHECK_FALSE(file.attributes[0].downwards);
  CHECK(file.attributes[1].kind == Kind::normal);
  CHECK(file.attributes[1].values == std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  CHECK(file.report.missing_values == 0);
}

TEST_CASE("OBJ: a seam stays at the corners, along a fan") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", kCorners +
                                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nvt 9 9\n"
                                                 "f 1/1 2/2 3/3 4/4\nf 3/5 2/2 1/-2\n");
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].values == std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1, 0.5F, 0.5F});
  CHECK(file.attributes[0].corners == Triangles{{0, 1, 2}, {0, 2, 3}, {4, 1, 4}});
}

TEST_CASE("OBJ: a triangle that goes takes its corners along") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.obj", kCorners + "vt 0 0\nvt 1 1\nf 1/1 1/2 2/2\nf 1/2 2/2 3/1\nf 1/1 3/2 4/2\n");
  CHECK(file.report.dropped_degenerate == 1);
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].corners == Triangles{{0, 0, 1}, {1, 0, 0}});
  CHECK(file.attributes[0].values == std::vector<float>{1, 1, 0, 0});
}

TEST_CASE("OBJ: values may come behind the faces that name them") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", "f 1//1 2//1 3//1\n" + kCorners + "vn 0 1 0\n");
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].values == std::vector<float>{0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0});
}

TEST_CASE("OBJ: indices of what is not there at all are noted") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", kCorners + "f 1/1/1 2/2/2 3/3/3\n");
  CHECK(file.attributes.empty());
  CHECK(file.report.ignored ==
        Names{"indices of texture coordinates that are not there", "indices of normals that are not there"});
}

TEST_CASE("OBJ: a cloud of points with normals") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", "v 0 0 0\nvn 0 0 1\nv 1 0 0\nvn 0 1 0\n");
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].per_vertex());
  CHECK(file.attributes[0].values == std::vector<float>{0, 0, 1, 0, 1, 0});
  CHECK(file.report.notes().empty());
}

TEST_CASE("OBJ: colours behind a weight") {
  const Folder folder;
  const auto colour = [&](const std::string& text) {
    const MeshFile file = folder.read("a.obj", text);
    REQUIRE(file.attributes.size() == 1);
    return file.attributes[0];
  };
  const std::string weighted = "v 0 0 0 1 0.2 0 1\nv 1 0 0 1.0 0 0.4 1\n";
  CHECK(colour(weighted).values == std::vector<float>{0.2F, 0, 1, 0, 0.4F, 1});
  CHECK(colour(weighted).bytes);
  CHECK(folder.read("a.obj", weighted).report.ignored == Names{"vertex weights"});
  const Attribute five = colour("v 0 0 0 0.5 1 0 1 0.75\nv 1 0 0 2 1 0 0 0.25\n");
  CHECK(five.components == 4);
  CHECK(five.values == std::vector<float>{1, 0, 1, 0.75F, 1, 0, 0, 0.25F});
  // Four numbers that begin with another than 1 are a colour with its opacity.
  CHECK(colour("v 0 0 0 1 0 0 0.5\nv 1 0 0 0.5 0 0 0.5\n").components == 4);
  // Ours would be taken for a weight, so it gets one.
  Attribute red = square_colours(false, true);
  for (std::size_t i = 0; i < red.values.size(); i += 4) red.values[i] = 1;
  CHECK(same_attribute(folder.there_and_back("a.obj", square(), {red}).attributes[0], red, square()));
}

TEST_CASE("OBJ: colours that count to 255") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", "v 0 0 0 255 0 51\nv 1 0 0 1 2 3\n");
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].bytes);
  CHECK(file.attributes[0].values[2] == 0.2F);
}

TEST_CASE("OBJ: colours behind coordinates") {
  const Folder folder;
  const auto colour = [&](const std::string& text) {
    const MeshFile file = folder.read("a.obj", text);
    REQUIRE(file.attributes.size() == 1);
    CHECK(file.attributes[0].kind == Kind::colour);
    return file.attributes[0];
  };
  const Attribute floats = colour("v 0 0 0 0.1 0.2 0.3\nv 1 0 0 1 1 1\n");
  CHECK(floats.components == 3);
  CHECK_FALSE(floats.bytes);
  CHECK(floats.values == std::vector<float>{0.1F, 0.2F, 0.3F, 1, 1, 1});

  const Attribute bytes = colour("v 0 0 0 0.2 0 1\n");  // 51, 0, 255
  CHECK(bytes.bytes);
  CHECK(bytes.values == std::vector<float>{0.2F, 0, 1});

  const Attribute opacity = colour("v 0 0 0 0.1 0.2 0.3\nv 1 0 0 1 1 1 0.5\n");
  CHECK(opacity.components == 4);
  CHECK(opacity.values == std::vector<float>{0.1F, 0.2F, 0.3F, 1, 1, 1, 1, 0.5F});

  const MeshFile some = folder.read("a.obj", "v 0 0 0\nv 1 0 0 0 0.1 0\nv 2 0 0\nv 3 0 0\n");
  CHECK(some.attributes[0].values == std::vector<float>{1, 1, 1, 0, 0.1F, 0, 1, 1, 1, 1, 1, 1});
  CHECK(some.report.missing_values == 3);
  CHECK(some.report.notes() ==
        Names{"3 corners or vertices without a value of an attribute that others have"});
}

TEST_CASE("OBJ: a value that is not finite becomes 0 and is counted") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", kCorners + "vn nan 0 1\nvt 1e99 2\nf 1/1/1 2/1/1 3/1/1\n");
  CHECK(file.report.zeroed_values == 2);
  CHECK(find(file.attributes, Kind::normal).values[0] == 0);
  CHECK(find(file.attributes, Kind::texture).values[0] == 0);
  CHECK(file.report.notes()[0] == "2 values of attributes not finite and read as 0");
}

TEST_CASE("OBJ: attributes as written") {
  const Folder folder;
  IndexedMesh mesh = square();
  const WriteReport all =
      write_mesh(folder / "a.obj", mesh, {}, {square_seam(), square_normals(), square_colours(false, false)});
  CHECK(all.notes().empty());
  CHECK(folder.get("a.obj") ==
        "v 0 0 0 0.1 0.15 0.2\nv 1 0 0 0.25 0.3 0.35\nv 1 1 0 0.4 0.45 0.5\nv 0 1 0.5 0.55 0.6 0.65\n"
        "vt 0 0.1\nvt 1 0.25\nvt 1 0.7\nvt 0.5 0\nvt 0.5 1\nvt 0.3 1\n"
        "vn 0 0 1\nvn 0 0.6 0.8\nvn 1 0 0\nvn -0.36 0.48 0.8\n"
        "f 1/1/1 2/2/2 3/3/3\nf 1/4/1 3/5/3 4/6/4\n");
  write_mesh(folder / "b.obj", mesh, {}, {square_normals()});
  CHECK(folder.get("b.obj").find("f 1//1 2//2 3//3\n") != std::string::npos);
  write_mesh(folder / "c.obj", mesh, {}, {square_texture()});
  CHECK(folder.get("c.obj").find("f 1/1 2/2 3/3\n") != std::string::npos);
}

TEST_CASE("OBJ: opacity is written only where there is some") {
  const Folder folder;
  Attribute colour = square_colours(false, true);
  const MeshFile clear = folder.there_and_back("a.obj", square(), {colour});
  CHECK(same_attribute(clear.attributes[0], colour, square()));
  for (std::size_t i = 3; i < 16; i += 4) colour.values[i] = 1;
  CHECK(folder.there_and_back("a.obj", square(), {colour}).attributes[0].components == 3);
}

}  // namespace
}  // namespace whittle::files
