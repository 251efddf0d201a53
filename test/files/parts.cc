/// \file
/// Parts of a mesh and their materials: OBJ's statements, libraries, and what is written beside a file.
#include "files/Outputs.hh"
#include "files/mtl.hh"
#include "files/obj_materials.hh"
#include "files/subset.hh"
#include "gltf_samples.hh"

namespace whittle::files {
namespace {

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kPng = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(16, '\1');

/// Two triangles of two materials, in a group and under a smoothing group.
std::string two_parts() {
  return "mtllib two.mtl\n" + kPoints +
         "o plate\ng left half\nusemtl red one\ns 1\nf 1 2 3\nusemtl blue\ns off\nf 1 3 4\n";
}

struct Named {
  std::string object, group, material, smoothing;
  bool operator==(const Named& other) const {
    return object == other.object && group == other.group && material == other.material &&
           smoothing == other.smoothing;
  }
};

Named named(const MeshFile& file, std::size_t face) {
  const Part& part = file.parts.list[file.parts.of_face[face]];
  return {part.object, part.group,
          part.material == Part::none ? "" : file.parts.materials[part.material].name, part.smoothing};
}

}  // namespace

TEST_CASE("OBJ: usemtl, o, g and s are said of the faces that follow") {
  const Folder folder;
  folder.put(
      "two.mtl",
      "newmtl red one\nKd 1 0 0\nmap_Kd -s 1 1 1 -clamp on my skin.png\nnewmtl blue\nKd 0 0 1\nd 0.25\n");
  folder.put("my skin.png", kPng);
  const MeshFile file = folder.read("a.obj", two_parts());
  CHECK(file.report.notes().empty());
  REQUIRE(file.parts.of_face.size() == 2);
  CHECK(named(file, 0) == Named{"plate", "left half", "red one", "1"});
  CHECK(named(file, 1) == Named{"plate", "left half", "blue", "off"});
  REQUIRE(file.parts.materials.size() == 2);
  CHECK(file.parts.materials[0].colour == std::array<double, 4>{1, 0, 0, 1});
  REQUIRE(file.parts.materials[0].image);
  CHECK(file.parts.images[*file.parts.materials[0].image].path.filename() == "my skin.png");
  CHECK(file.parts.materials[1].colour == std::array<double, 4>{0, 0, 1, 0.25});
  CHECK(file.parts.materials[1].alpha == Material::Alpha::blend);
  CHECK(file.parts.areas() == std::vector<std::uint32_t>{0, 1});
}

TEST_CASE("OBJ: faces under the same statements are one part, written together") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.obj", kPoints + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl a\nf 2 3 4\n");
  CHECK(file.parts.list.size() == 2);
  CHECK(file.parts.of_face == std::vector<std::uint32_t>{0, 1, 0});
  write_mesh(folder / "b.obj", file.mesh, {}, {}, file.parts);
  CHECK(folder.get("b.obj") ==
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        "usemtl a\nf 1 2 3\nf 2 3 4\nusemtl b\nf 1 3 4\n");
}

TEST_CASE("OBJ: a file without such statements has no parts, and one part alone makes no seam") {
  const Folder folder;
  CHECK(folder.read("a.obj", kPoints + "f 1 2 3\n").parts.of_face.empty());
  const MeshFile file = folder.read("b.obj", kPoints + "usemtl a\ng x\nf 1 2 3\ng y\nf 1 3 4\n");
  CHECK(file.parts.areas().empty());
  CHECK(file.parts.areas(true) == std::vector<std::uint32_t>{0, 1});
}

TEST_CASE("OBJ: a part goes along when faces are left out") {
  const Folder folder;
  const MeshFile file =
      folder.read("a.obj", kPoints + "usemtl a\nf 1 1 2\nf 1 2 3\nusemtl b\nf 1 2 3\nf 1 3 4\n", Repair::fix);
  CHECK(file.report.duplicate_faces == 1);
  CHECK(file.parts.of_face == std::vector<std::uint32_t>{0, 1});
}

TEST_CASE("OBJ: a polygon's triangles are all of its part") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", kPoints + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3 4\n");
  CHECK(file.parts.of_face == std::vector<std::uint32_t>{0, 1, 1});
}

TEST_CASE("OBJ: a library is referred to where it is") {
  const Folder folder;
  std::filesystem::create_directories(folder / "in/textures");
  std::filesystem::create_directories(folder / "out");
  folder.put("in/two.mtl", "newmtl red one\nmap_Kd textures/a.png\nnewmtl blue\n");
  folder.put("in/textures/a.png", kPng);
  const MeshFile file = folder.read("in/a.obj", two_parts());
  const WriteReport report = write_mesh(folder / "out/b.obj", file.mesh, {}, {}, file.parts);
  CHECK(folder.get("out/b.obj").rfind("mtllib ../in/two.mtl\n", 0) == 0);
  CHECK(report.materials == "materials in ../in/two.mtl");
  CHECK_FALSE(std::filesystem::exists(folder / "out/two.mtl"));
  const MeshFile back = read_mesh(folder / "out/b.obj");
  CHECK(named(back, 0) == named(file, 0));
  CHECK(named(back, 1) == named(file, 1));
  // What Whittle has written it reads with all that it names.
  CHECK(back.report.notes().empty());
  REQUIRE(back.parts.images.size() == 1);
  CHECK(std::filesystem::equivalent(back.parts.images[0].path, folder / "in/textures/a.png"));
}

TEST_CASE("OBJ: a library is copied with its images, whose names follow") {
  const Folder folder;
  std::filesystem::create_directories(folder / "in/textures");
  std::filesystem::create_directories(folder / "out");
  folder.put("in/two.mtl",
             "newmtl red one\r\nbump -bm 0.5 textures/a.png\r\nmap_Kd b.png\nnewmtl blue\nKd 0 0 1");
  folder.put("in/textures/a.png", kPng);
  folder.put("in/b.png", "other");
  const MeshFile file = folder.read("in/a.obj", two_parts());
  WriteOptions options;
  options.copy_materials = true;
  write_mesh(folder / "out/b.obj", file.mesh, options, {}, file.parts);
  CHECK(folder.get("out/b.obj").rfind("mtllib two.mtl\n", 0) == 0);
  CHECK(folder.get("out/two.mtl") ==
        "newmtl red one\r\nbump -bm 0.5 a.png\r\nmap_Kd b.png\nnewmtl blue\nKd 0 0 1");
  CHECK(folder.get("out/a.png") == kPng);
  CHECK(folder.get("out/b.png") == "other");
  // The same again changes nothing; another file of the name is not replaced, and nothing else appears.
  write_mesh(folder / "out/b.obj", file.mesh, options, {}, file.parts);
  folder.put("out/a.png", "mine");
  std::filesystem::remove(folder / "out/b.obj");
  CHECK_THAT(folder.message([&] { write_mesh(folder / "out/b.obj", file.mesh, options, {}, file.parts); }),
             Catch::Matchers::Contains("out/a.png: would be written beside the result"));
  CHECK(folder.get("out/a.png") == "mine");
  CHECK_FALSE(std::filesystem::exists(folder / "out/b.obj"));
}

TEST_CASE("OBJ: a library that is missing is noted, stays named, and its materials keep their names") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", two_parts());
  CHECK(file.report.not_found == std::set<std::string>{"two.mtl"});
  CHECK(file.report.notes() == Names{"not found: two.mtl"});
  write_mesh(folder / "b.obj", file.mesh, {}, {}, file.parts);
  CHECK(named(read_mesh(folder / "b.obj"), 0) == named(file, 0));
  CHECK(folder.get("b.obj").rfind("mtllib two.mtl\n", 0) == 0);
}

TEST_CASE("OBJ: libraries and images are found by any relative path, with slashes or backslashes") {
  const Folder folder;
  std::filesystem::create_directories(folder / "in/models");
  std::filesystem::create_directories(folder / "in/textures");
  std::filesystem::create_directories(folder / "out/deep");
  folder.put("in/textures/a.png", kPng);
  folder.put("in/two.mtl",
             "newmtl red one\nKd 0 1 0\nmap_Kd textures\\a.png\nmap_Bump ../gone.png\nnewmtl blue\n");
  std::string text = two_parts();
  text.replace(text.find("two.mtl"), 7, "..\\two.mtl");
  const MeshFile file = folder.read("in/models/a.obj", text);
  CHECK(file.report.notes() == Names{"not found: ../gone.png"});
  CHECK(file.parts.materials[0].colour[0] == 0);
  WriteOptions options;
  options.copy_materials = true;
  write_mesh(folder / "out/deep/b.obj", file.mesh, options, {}, file.parts);
  CHECK(folder.get("out/deep/b.obj").rfind("mtllib two.mtl\n", 0) == 0);
  // What could not be copied is named from where the copy is.
  CHECK(folder.get("out/deep/two.mtl") ==
        "newmtl red one\nKd 0 1 0\nmap_Kd a.png\nmap_Bump ../../gone.png\nnewmtl blue\n");
  CHECK(folder.get("out/deep/a.png") == kPng);
  write_mesh(folder / "out/c.obj", file.mesh, {}, {}, file.parts);
  CHECK(folder.get("out/c.obj").rfind("mtllib ../in/two.mtl\n", 0) == 0);
}

TEST_CASE("OBJ: what lies outside of the folder is read and copied only where it is what it is said to be") {
  const Folder folder;
  std::filesystem::create_directories(folder / "in");
  std::filesystem::create_directories(folder / "out");
  folder.put("secret", "a password\n");
  folder.put("good.mtl", "newmtl a\nKd 0 1 0\nmap_Kd secret\n");
  const auto read = [&](const std::string& name) {
    return folder.read("in/a.obj", "mtllib " + name + "\n" + kPoints + "usemtl a\nf 1 2 3\n");
  };
  CHECK(read("../secret").report.refused ==
        std::set<std::string>{"'../secret', which is no library of materials"});
  const std::string absolute = (folder / "good.mtl").string();
  CHECK(read(absolute).report.notes() == Names{"refused: '" + absolute + "', an absolute path"});
  CHECK(read("C:\\good.mtl").report.refused == std::set<std::string>{"'C:\\good.mtl', an absolute path"});
  CHECK(read("https://a.b/c.mtl").report.notes() == Names{"refused: 'https://a.b/c.mtl', a URL"});
  std::filesystem::create_directories(folder / "in/sub.mtl");
  CHECK(read("sub.mtl").report.not_found == std::set<std::string>{"sub.mtl"});
  folder.put("in/own.mtl", "newmtl a\nmap_Kd ../secret\n");
  const MeshFile file = read("own.mtl");
  WriteOptions options;
  options.copy_materials = true;
  write_mesh(folder / "out/b.obj", file.mesh, options, {}, file.parts);
  CHECK(folder.get("out/own.mtl") == "newmtl a\nmap_Kd ../secret\n");
  CHECK_FALSE(std::filesystem::exists(folder / "out/secret"));
  CHECK_THAT(write_mesh(folder / "out/b.glb", file.mesh, {}, {}, file.parts).left_out.at(0),
             Catch::Matchers::Contains("which is neither PNG nor JPEG"));
}

TEST_CASE("OBJ: several libraries on a line, and one with blanks in its name") {
  const Folder folder;
  folder.put("a.mtl", "newmtl a\nKd 1 0 0\n");
  folder.put("b c.mtl", "newmtl b\nKd 0 1 0\n");
  const MeshFile file = folder.read(
      "a.obj", "mtllib a.mtl d.mtl\nmtllib b c.mtl\n" + kPoints + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
  CHECK(file.parts.materials[0].colour[0] == 1);
  CHECK(file.parts.materials[1].colour[1] == 1);
  CHECK(file.report.not_found == std::set<std::string>{"d.mtl"});
}

TEST_CASE("materials: from OBJ to GLB and back, with image and opacity") {
  const Folder folder;
  std::filesystem::create_directories(folder / "back");
  folder.put("two.mtl", "newmtl red one\nKd 1 0.5 0\nmap_Kd a.png\nnewmtl blue\nKd 0 0 1\nd 0.25\n");
  folder.put("a.png", kPng);
  const MeshFile file = folder.read("a.obj", two_parts());
  write_mesh(folder / "b.glb", file.mesh, {}, {}, file.parts);
  const Json json = json_of(folder.get("b.glb"));
  REQUIRE(json["materials"].size() == 2);
  CHECK(json["materials"][0]["name"] == "red one");
  CHECK(json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] == Json({1.0, 0.5, 0.0, 1.0}));
  CHECK(json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 0);
  CHECK(json["materials"][1]["alphaMode"] == "BLEND");
  CHECK(json["images"][0]["mimeType"] == "image/png");
  REQUIRE(json["meshes"][0]["primitives"].size() == 2);
  CHECK(json["meshes"][0]["primitives"][1]["material"] == 1);

  const MeshFile glb = read_mesh(folder / "b.glb");
  CHECK(glb.mesh.points.size() == 4);
  CHECK(glb.parts.areas() == std::vector<std::uint32_t>{0, 1});
  write_mesh(folder / "back/c.obj", glb.mesh, {}, {}, glb.parts);
  CHECK(folder.get("back/c.mtl") ==
        "# whittle: the materials of c.obj\nnewmtl red one\nKd 1 0.5 0\nmap_Kd c-a.png\n\nnewmtl blue\n"
        "Kd 0 0 1\nd 0.25\n");
  CHECK(folder.get("back/c-a.png") == kPng);
  const MeshFile obj = read_mesh(folder / "back/c.obj");
  CHECK(obj.report.notes().empty());
  CHECK(named(obj, 0).material == "red one");
  CHECK(obj.parts.materials[1].colour == file.parts.materials[1].colour);
  // What belongs to the old file goes with it.
  Parts other = glb.parts;
  other.materials[0].colour[1] = 0.25;
  write_mesh(folder / "back/c.obj", glb.mesh, {}, {}, other);
  const MeshFile again = read_mesh(folder / "back/c.obj");
  CHECK(again.parts.materials[0].colour[1] == 0.25);
  CHECK(again.parts.libraries[0].name.find("c-") == 0);
  CHECK_FALSE(std::filesystem::exists(folder / "back/c.mtl"));
}

TEST_CASE("materials: formats without them leave them out, and say so") {
  const Folder folder;
  const MeshFile file = folder.read("a.obj", two_parts());
  for (const std::string name : {"b.stl", "b.off", "b.om"})
    CHECK_THAT(write_mesh(folder / name, file.mesh, {}, {}, file.parts).left_out,
               Catch::Matchers::VectorContains(std::string("materials")));
  CHECK(holds_materials("a.obj"));
  CHECK_FALSE(holds_materials("a.stl"));
}

TEST_CASE("materials: parts that do not fit the mesh are not written") {
  const Folder folder;
  MeshFile file = folder.read("a.obj", two_parts());
  file.parts.of_face.push_back(0);
  CHECK(folder.message([&] { write_mesh(folder / "b.obj", file.mesh, {}, {}, file.parts); }) ==
        "b.obj: not written: parts do not fit the mesh");
}

TEST_CASE("materials: names for OBJ are of one line and differ") {
  std::vector<Material> materials(4);
  materials[0].name = "a\nb";
  materials[1].name = " a b ";
  materials[3].name = "c";
  CHECK(obj_material_names(materials) == Names{"a b", "a b-1", "material-2", "c"});
}

TEST_CASE("faces_alone: some faces with the vertices and values that they use") {
  const IndexedMesh mesh = square();
  const FacesAlone alone = faces_alone(mesh, {square_normals(), square_seam()}, {1});
  CHECK(alone.vertices == std::vector<std::uint32_t>{0, 2, 3});
  CHECK(alone.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(alone.attributes[0].values == std::vector<float>{0, 0, 1, 1, 0, 0, -0.36F, 0.48F, 0.8F});
  CHECK(alone.attributes[1].values == std::vector<float>{0.5F, 0, 0.5F, 1, 0.3F, 1});
  CHECK(alone.attributes[1].corners == Triangles{{0, 1, 2}});
}

}  // namespace whittle::files
