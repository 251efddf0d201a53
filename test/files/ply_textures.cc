/// \file
/// PLY: images that comments name, and the faces' numbers of them.
#include <algorithm>

#include "gltf_samples.hh"

namespace whittle::files {
namespace {

const std::string kImage = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(20, '\1');

std::string meshlab(const std::string& images, const std::string& numbers, const std::string& faces) {
  return "ply\nformat ascii 1.0\n" + images +
         "element vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n"
         "property list uchar int vertex_indices\nproperty list uchar float texcoord\n" +
         numbers + "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n" + faces;
}

/// A square and a triangle of the second image, and a triangle of none.
MeshFile two_images(const Folder& folder) {
  folder.put("a b.png", kImage);
  return folder.read("a.ply", meshlab("comment TextureFile a b.png\ncomment TextureFile sub/c.png\n",
                                      "property int texnumber\n",
                                      "4 0 1 2 3 8 0 0 1 0 1 1 0 1 1\n3 3 2 4 6 0 0 1 0 0.5 1 -1\n"
                                      "3 0 3 1 6 0 0 1 0 0.5 1 0\n"));
}

}  // namespace

TEST_CASE("PLY: each image is a material, and faces know theirs") {
  const Folder folder;
  const MeshFile file = two_images(folder);
  CHECK(file.report.ignored.empty());
  CHECK(file.report.not_found == std::set<std::string>{"sub/c.png"});
  REQUIRE(file.parts.materials.size() == 2);
  CHECK(file.parts.materials[0].name == "a b");
  CHECK(file.parts.materials[1].name == "c");
  CHECK(file.parts.images[0].path == folder / "a b.png");
  CHECK(file.parts.images[1].path.empty());
  CHECK(file.parts.areas() == std::vector<std::uint32_t>{1, 1, Part::none, 0});
}

TEST_CASE("PLY: without numbers all faces have the first image, and without images numbers say nothing") {
  const Folder folder;
  const std::string faces = "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 0\n3 2 4 3 6 0 0 1 0 1 1\n";
  const MeshFile one = folder.read("a.ply", meshlab("comment TextureFile a.png\n", "", faces));
  CHECK(one.parts.of_face == std::vector<std::uint32_t>{0, 0, 0});
  CHECK(one.parts.list[0].material == 0);
  const MeshFile none =
      folder.read("a.ply", meshlab("comment TextureFile\n", "property int texnumber\n",
                                   "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 0 0\n3 2 4 3 6 0 0 1 0 1 1 1\n"));
  CHECK(none.parts.of_face.empty());
  CHECK(none.report.ignored == Names{"face property 'texnumber'"});

  std::string many = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 1001; ++i) many += "comment TextureFile a\n";
  CHECK(folder.error("a.ply", many) == "a.ply:1003: the header names more than 1000 images");
}

TEST_CASE("PLY: images and numbers there and back") {
  const Folder folder;
  const MeshFile file = two_images(folder);
  for (const bool ascii : {true, false}) {
    WriteOptions options;
    options.ascii = ascii;
    const WriteReport report = write_mesh(folder / "b.ply", file.mesh, options, file.attributes, file.parts);
    CHECK(report.notes().empty());
    CHECK(report.materials == "textures a b.png, sub/c.png");
    const MeshFile back = read_mesh(folder / "b.ply");
    CHECK(same_bits<float>(back.mesh, file.mesh));
    CHECK(back.parts.areas() == file.parts.areas());
    CHECK(back.parts.materials[1].name == "c");
    REQUIRE(back.attributes.size() == 1);
    CHECK(same_attribute(back.attributes[0], file.attributes[0], file.mesh));
  }
  // Copies go beside the file; one image for all needs no numbers.
  std::filesystem::create_directories(folder / "far");
  Parts parts = file.parts;
  parts.of_face.assign(4, 0);
  parts.images.pop_back();
  parts.materials.pop_back();
  parts.list = {{0, "", "", ""}};
  write_mesh(folder / "far/c.ply", file.mesh, {}, file.attributes, parts);
  const auto begins = [&](const std::string& text) {
    const std::string all = folder.get("far/c.ply");
    CHECK(all.find("texnumber") == std::string::npos);
    return all.find("\ncomment TextureFile " + text + "\nelement vertex") != std::string::npos;
  };
  CHECK(begins("../a b.png"));
  WriteOptions copying;
  copying.copy_materials = true;
  CHECK(write_mesh(folder / "far/c.ply", file.mesh, copying, file.attributes, parts).materials ==
        "textures a b.png");
  CHECK(begins("a b.png"));
  CHECK(folder.get("far/a b.png") == kImage);
}

TEST_CASE("PLY: images from OBJ and glTF, and to them") {
  const Folder folder;
  const MeshFile file = two_images(folder);
  // OBJ names both, GLB holds the one that is there.
  CHECK(write_mesh(folder / "b.obj", file.mesh, {}, file.attributes, file.parts).materials ==
        "materials in b.mtl");
  CHECK(folder.get("b.mtl") ==
        "# whittle: the materials of b.obj\nnewmtl a b\nKd 1 1 1\nmap_Kd a b.png\n\nnewmtl c\nKd 1 1 "
        "1\nmap_Kd sub/c.png\n");
  CHECK(write_mesh(folder / "b.glb", file.mesh, {}, file.attributes, file.parts).left_out ==
        Names{"image 'sub/c.png'"});
  const MeshFile obj = read_mesh(folder / "b.obj"), glb = read_mesh(folder / "b.glb");
  write_mesh(folder / "c.ply", obj.mesh, {}, obj.attributes, obj.parts);
  const MeshFile of_obj = read_mesh(folder / "c.ply");
  REQUIRE(of_obj.parts.materials.size() == 1);  // that of the image that is there
  std::vector<std::uint32_t> areas = of_obj.parts.areas();
  std::sort(areas.begin(), areas.end());
  CHECK(areas == std::vector<std::uint32_t>{0, Part::none, Part::none, Part::none});

  const WriteReport report = write_mesh(folder / "d.ply", glb.mesh, {}, glb.attributes, glb.parts);
  CHECK(report.materials == "textures d-a_b.png");
  CHECK(report.reduced == Names{"of the materials only the images of their colours are written"});
  CHECK(folder.get("d-a_b.png") == kImage);
  CHECK(folder.get("d.ply").find("comment TextureFile d-a_b.png\n") != std::string::npos);
}

}  // namespace whittle::files
