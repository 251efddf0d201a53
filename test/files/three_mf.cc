/// \file
/// 3MF, and the ZIP archives that it is in.
#include "files/Zip.hh"
#include "meshes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

const std::string kRelations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
    "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
    "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
const std::string kTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types "
    "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>";

/// A package with this in its model.
std::string package(const std::string& resources, const std::string& build,
                    const std::string& unit = "millimeter") {
  ZipWriter zip;
  zip.add("[Content_Types].xml", kTypes);
  zip.add("_rels/.rels", kRelations);
  zip.add("3D/3dmodel.model",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" + unit +
              "\" xml:lang=\"en-US\" "
              "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
              resources + "</resources><build>" + build + "</build></model>");
  return zip.take();
}

const std::string kTetrahedron =
    "<object id=\"1\" type=\"model\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" "
    "y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" "
    "v3=\"3\"/>"
    "<triangle v1=\"2\" v2=\"0\" v3=\"3\"/></triangles></mesh></object>";

TEST_CASE("3MF: what is written is read, float for float, and the same bytes each time") {
  const Folder folder;
  const IndexedMesh mesh = rounded(meshes::torus(24, 16));
  CHECK(write_mesh(folder / "a.3mf", mesh, {false, true}).notes().empty());
  write_mesh(folder / "b.3mf", mesh, {false, true});
  CHECK(folder.get("a.3mf") == folder.get("b.3mf"));
  CHECK(write_mesh(folder / "c.3mf", square(), {}, {square_normals()}).left_out == Names{"normals"});
  const MeshFile file = read_mesh(folder / "a.3mf");
  CHECK(file.report.format == "3MF");
  CHECK(file.report.notes().empty());
  CHECK(same_bits<float>(file.mesh, mesh));
  CHECK(folder.message([&] { write_mesh(folder / "d.3mf", {}); }) ==
        "d.3mf: not written: 3MF holds no mesh without faces");
}

TEST_CASE("3MF: items and components are put in their places") {
  const Folder folder;
  const MeshFile one = folder.read("a.3mf", package(kTetrahedron, "<item objectid=\"1\"/>"));
  CHECK(one.mesh.triangles == Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(one.report.parts == 0);

  const std::string pair =
      "<object id=\"2\" type=\"model\"><components><component objectid=\"1\"/>"
      "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 -10 0 0\"/></components></object>";
  const MeshFile placed = folder.read(
      "a.3mf",
      package(kTetrahedron + pair,
              "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 5\"/><item objectid=\"1\"/>", "inch"));
  REQUIRE(placed.mesh.points.size() == 12);
  CHECK(placed.report.parts == 3);
  CHECK(placed.mesh.points[3] == IndexedMesh::Point(0, 0, 7));
  CHECK(placed.mesh.points[5] == IndexedMesh::Point(-22, 0, 5));
  CHECK(placed.mesh.triangles[4] == IndexedMesh::Triangle{4, 5, 6});  // mirrored, so turned round
  CHECK(placed.mesh.points[11] == IndexedMesh::Point(0, 0, 1));
  CHECK(placed.report.ignored.empty());
  CHECK(placed.unit == "inch");
}

TEST_CASE("3MF: unit, objects and their names are kept, and other formats say that they know no unit") {
  const Folder folder;
  std::string named = kTetrahedron;
  named.replace(named.find("id=\"1\""), 6, "id=\"2\" name=\"A &amp; B\"");
  const MeshFile file = folder.read(
      "a.3mf", package(kTetrahedron + named,
                       "<item objectid=\"2\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>"
                       "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/>",
                       "inch"));
  REQUIRE(file.parts.list.size() == 3);
  CHECK(file.parts.list[0].object == "A & B");
  WriteOptions options;
  options.unit = file.unit;
  const WriteReport report = write_mesh(folder / "b.3mf", file.mesh, options, {}, file.parts);
  CHECK(report.notes().empty());
  CHECK(report.first_vertex.at(8) == 8);
  const MeshFile back = read_mesh(folder / "b.3mf");
  CHECK(back.unit == "inch");
  REQUIRE(back.parts.list.size() == 3);
  CHECK(back.parts.list[0].object == "A & B");
  CHECK(back.parts.list[1].object.empty());
  CHECK(back.parts.list[2].object == "A & B");
  CHECK(back.parts.of_face == file.parts.of_face);
  CHECK(back.mesh.points == file.mesh.points);
  for (const char* other : {"b.obj", "b.stl", "b.ply", "b.glb"})
    CHECK(write_mesh(folder / other, file.mesh, options, {}, file.parts).left_out ==
          Names{"the unit, 'inch'"});
  CHECK_THAT(folder.get("b.obj"), Catch::Matchers::Contains("o A & B\n"));

  const MeshFile odd = folder.read("a.3mf", package(kTetrahedron, "<item objectid=\"1\"/>", "mile"));
  CHECK(odd.report.ignored == Names{"the unit, 'mile', which 3MF does not know"});
  CHECK(odd.unit.empty());
}

TEST_CASE("3MF: parts that share a vertex are one object") {
  const Folder folder;
  Parts parts;
  parts.list = {{Part::none, "a", "", ""}, {Part::none, "b", "", ""}};
  parts.of_face = {0, 1};
  write_mesh(folder / "a.3mf", square(), {}, {}, parts);
  const MeshFile back = read_mesh(folder / "a.3mf");
  CHECK(back.mesh.points.size() == 4);
  CHECK(back.parts.list.empty());
}

TEST_CASE("3MF: objects may stand in another model of the archive, as slicers write them") {
  const Folder folder;
  ZipWriter zip;
  zip.add("_rels/.rels", kRelations);
  zip.add(
      "3D/3dmodel.model",
      "<model xmlns:p='x'><!-- <item/> --><resources><object id='8'><components><component "
      "p:path='/3D/Objects/a.model' objectid='1' transform='1 0 0 0 1 0 0 0 1 0 0 3'/></components></object>"
      "</resources><build><item objectid='8'/></build></model>");
  zip.add("3D/Objects/a.model", "<model><resources>" + kTetrahedron + "</resources><build/></model>");
  const MeshFile file = folder.read("a.3mf", zip.take());
  CHECK(file.mesh.triangles.size() == 4);
  CHECK(file.mesh.points[3] == IndexedMesh::Point(0, 0, 4));
}

TEST_CASE("3MF: what is missing or wrong is named") {
  const Folder folder;
  const auto error = [&](const std::string& resources, const std::string& build) {
    return folder.error("a.3mf", package(resources, build));
  };
  CHECK(error(kTetrahedron, "<item objectid=\"2\"/>") == "a.3mf: there is no object '2'");
  CHECK(error(kTetrahedron + kTetrahedron, "") == "a.3mf: a second object '1'");
  CHECK(error("<object id='1'><mesh><vertices><vertex x='0' y='0'/>", "") ==
        "a.3mf: expected a number, found ''");
  CHECK(error("<object id='1'><mesh><triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh></object>",
              "<item objectid='1'/>") == "a.3mf: vertex index 0 is out of range: there are 0 vertices");
  CHECK(error("<object id='1'><components><component objectid='1'/></components></object>",
              "<item objectid='1'/>") == "a.3mf: components within components, more than 64 deep");
  CHECK(error("<object id=1>", "") == "a.3mf: the XML in it is damaged");
  CHECK(error("<!DOCTYPE lolz>", "") == "a.3mf: XML with a document type is not read");
  ZipWriter zip;
  zip.add("a.txt", "not a model");
  CHECK(folder.error("a.3mf", zip.take()) == "a.3mf: the ZIP archive has no file '_rels/.rels'");
}

TEST_CASE("3MF: a build that multiplies itself is refused") {
  const Folder folder;
  std::string objects = kTetrahedron;
  for (int id = 2; id < 40; ++id) {
    const std::string inner = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    objects += "<object id=\"" + std::to_string(id) + "\" type=\"model\"><components>" + inner + inner +
               "</components></object>";
  }
  CHECK(folder.error("a.3mf", package(objects, "<item objectid=\"39\"/>")) ==
        "a.3mf: the build is too many times as large as the file");
}

TEST_CASE("3MF: archives that are cut off, damaged, or claim too much are refused") {
  const Folder folder;
  const std::string good = package(kTetrahedron, "<item objectid=\"1\"/>");
  CHECK(folder.error("a.3mf", good.substr(0, good.size() - 1)) == "a.3mf: the ZIP archive is cut off");
  CHECK(folder.error("a.3mf", "PK\3\4") == "a.3mf: the ZIP archive is cut off");
  std::string elsewhere = good;
  elsewhere[good.size() - 6] = '\x7f';  // where the directory begins
  CHECK(folder.error("a.3mf", elsewhere) == "a.3mf: the ZIP archive is damaged");
  std::string claim = good;
  const std::size_t directory = good.find("PK\1\2");
  claim.replace(directory + 24, 4, "\0\0\0\x7f", 4);
  CHECK(
      folder.error("a.3mf", claim) ==
      "a.3mf: it unpacks to more than 100 times its size, as no mesh does; unpack it first if you trust it");
  for (std::size_t i = 0; i + 1 < good.size(); i += 3) {
    std::string bytes = good;
    bytes[i] = static_cast<char>(~bytes[i]);
    INFO(i);
    folder.error("a.3mf", bytes);  // whatever it is, it ends
  }
}

TEST_CASE("3MF: what a model requires must be known, and a transform has twelve numbers") {
  const Folder folder;
  const std::string item = "<item objectid=\"1\"/>";
  const auto error = [&](const std::string& attributes) {
    return folder.error("a.3mf", package(kTetrahedron, item, "inch\" " + attributes + " x=\""));
  };
  CHECK(error("xmlns:zz=\"http://acme/x\" requiredextensions=\"zz\"") ==
        "a.3mf: it needs the extension 'http://acme/x', which is not supported");
  CHECK(error("requiredextensions=\" q\"") == "a.3mf: it needs the extension 'q', which is not supported");
  const std::string production =
      "inch\" xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
      "requiredextensions=\"p\" x=\"";
  CHECK(folder.read("a.3mf", package(kTetrahedron, item, production)).mesh.triangles.size() == 4);
  for (const std::string transform :
       {"1 0 0 0 1 0 0 0 1 0 0", "1 0 0 0 1 0 0 0 1 0 0 0 0", "1 0 0 0 1 0 0 0 1 a 0 0"})
    CHECK(folder.error("a.3mf",
                       package(kTetrahedron, "<item objectid=\"1\" transform=\"" + transform + "\"/>")) ==
          "a.3mf: a transform that is not twelve numbers: '" + transform + "'");
}

}  // namespace
}  // namespace whittle::files
