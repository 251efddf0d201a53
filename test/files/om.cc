/// \file
/// OM, chunk by chunk, and against OpenMesh's own reader and writer.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "files/bytes.hh"
#include "files/om_format.hh"
#include "meshes.hh"
#include "samples.hh"

namespace whittle::files {
namespace {

using om::ChunkHeader;
using om::Entity;
using om::Type;

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color |
                   OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

const OpenMesh::IO::Options everything(OpenMesh::IO::Options::Binary | OpenMesh::IO::Options::VertexNormal |
                                       OpenMesh::IO::Options::VertexColor |
                                       OpenMesh::IO::Options::VertexTexCoord);

/// A square of two triangles with a value of everything.
Mesh sample() {
  Mesh mesh;
  const IndexedMesh square = files::square();
  std::vector<Mesh::VertexHandle> vertices;
  for (const IndexedMesh::Point& p : square.points)
    vertices.push_back(mesh.add_vertex(
        Mesh::Point(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()))));
  for (const auto& [a, b, c] : square.triangles) mesh.add_face(vertices[a], vertices[b], vertices[c]);
  OpenMesh::VPropHandleT<float> quality;
  mesh.add_property(quality, "quality");
  mesh.property(quality).set_persistent(true);
  for (const auto vertex : mesh.vertices()) {
    const auto i = static_cast<std::size_t>(vertex.idx());
    mesh.set_normal(vertex, Mesh::Normal(0, 0.6F, 0.8F));
    mesh.set_color(vertex, Mesh::Color(static_cast<unsigned char>(10 * i), 20, 255));
    mesh.set_texcoord2D(vertex, Mesh::TexCoord2D(0.25F, static_cast<float>(i)));
    mesh.property(quality, vertex) = 0.5F * static_cast<float>(i);
  }
  return mesh;
}

TEST_CASE("OM: what OpenMesh writes is read") {
  const Folder folder;
  Mesh mesh = sample();
  REQUIRE(OpenMesh::IO::write_mesh(mesh, (folder / "a.om").string(), everything));
  const MeshFile file = read_mesh(folder / "a.om");
  CHECK(file.report.format == "OM");
  CHECK(file.report.notes().empty());
  CHECK(file.single_precision);
  CHECK(file.mesh.triangles == square().triangles);
  CHECK(same_bits<double>(file.mesh, square()));
  CHECK(find(file.attributes, Kind::normal).values[1] == 0.6F);
  const Attribute& colour = find(file.attributes, Kind::colour);
  CHECK(colour.bytes);
  CHECK(colour.components == 3);
  CHECK(colour.values[3] == 10 / 255.0F);
  CHECK(colour.values[5] == 1);
  CHECK(find(file.attributes, Kind::texture).values ==
        std::vector<float>{0.25F, 0, 0.25F, 1, 0.25F, 2, 0.25F, 3});
  CHECK(find(file.attributes, Kind::scalar, "quality").values == std::vector<float>{0, 0.5F, 1, 1.5F});
}

TEST_CASE("OM: texture coordinates of half-edges become those of corners") {
  const Folder folder;
  Mesh mesh = sample();
  for (const auto face : mesh.faces())
    for (const auto half : mesh.fh_range(face))
      mesh.set_texcoord2D(
          half, Mesh::TexCoord2D(static_cast<float>(face.idx()), static_cast<float>(half.to().idx())));
  REQUIRE(OpenMesh::IO::write_mesh(mesh, (folder / "a.om").string(),
                                   everything | OpenMesh::IO::Options(OpenMesh::IO::Options::FaceTexCoord)));
  const MeshFile file = read_mesh(folder / "a.om");
  const Attribute& texture = find(file.attributes, Kind::texture);
  REQUIRE_FALSE(texture.per_vertex());
  for (std::size_t face = 0; face < 2; ++face) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float* value = texture.value(texture.at(file.mesh, face, k));
      CHECK(value[0] == static_cast<float>(face));
      CHECK(value[1] == static_cast<float>(file.mesh.triangles[face][k]));
    }
  }
}

TEST_CASE("OM: doubles stay doubles, both ways") {
  const Folder folder;
  const IndexedMesh mesh = meshes::torus(8, 6);
  DoubleMesh theirs;
  std::vector<DoubleMesh::VertexHandle> vertices;
  for (const IndexedMesh::Point& p : mesh.points)
    vertices.push_back(theirs.add_vertex(DoubleMesh::Point(p.x(), p.y(), p.z())));
  for (const auto& [a, b, c] : mesh.triangles) theirs.add_face(vertices[a], vertices[b], vertices[c]);
  REQUIRE(OpenMesh::IO::write_mesh(theirs, (folder / "a.om").string()));
  const MeshFile file = read_mesh(folder / "a.om");
  CHECK_FALSE(file.single_precision);
  CHECK(same_bits<double>(file.mesh, mesh));

  write_mesh(folder / "b.om", mesh);
  DoubleMesh back;
  REQUIRE(OpenMesh::IO::read_mesh(back, (folder / "b.om").string()));
  REQUIRE(back.n_vertices() == mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(back.point(back.vertex_handle(static_cast<unsigned>(i)))[k] == mesh.points[i][k]);
}

/// The mesh as OpenMesh has it, and its connectivity is in order.
IndexedMesh as_openmesh_has_it(const Mesh& mesh) {
  IndexedMesh result;
  for (const auto vertex : mesh.vertices()) {
    const Mesh::Point p = mesh.point(vertex);
    result.points.emplace_back(p[0], p[1], p[2]);
    if (!vertex.halfedge().is_valid()) continue;
    CHECK(vertex.halfedge().from() == vertex);
    CHECK(vertex.is_boundary() == vertex.halfedge().is_boundary());
  }
  for (const auto half : mesh.halfedges()) {
    CHECK(half.next().prev() == half);
    CHECK(half.next().from() == half.to());
    CHECK(half.next().face() == half.face());
  }
  for (const auto face : mesh.faces()) {
    IndexedMesh::Triangle triangle{};
    std::size_t k = 0;
    for (const auto vertex : mesh.fv_range(face)) triangle[k++] = static_cast<std::uint32_t>(vertex.idx());
    result.triangles.push_back(triangle);
  }
  return result;
}

TEST_CASE("OM: OpenMesh reads the files that Whittle writes") {
  const Folder folder;
  write_mesh(
      folder / "a.om", square(), {false, true},
      {square_normals(), square_colours(true, false), square_texture(), scalar("quality", {1, 2, 3, 4})});
  Mesh mesh;
  OpenMesh::VPropHandleT<float> quality;
  mesh.add_property(quality, "quality");
  OpenMesh::IO::Options options = everything;
  REQUIRE(OpenMesh::IO::read_mesh(mesh, (folder / "a.om").string(), options));
  CHECK(same_bits<double>(as_openmesh_has_it(mesh), square()));
  CHECK(options.vertex_has_normal());
  CHECK(options.vertex_has_color());
  CHECK(options.vertex_has_texcoord());
  const auto last = mesh.vertex_handle(3);
  CHECK(mesh.normal(last)[0] == -0.36F);
  CHECK(mesh.color(last)[2] == 17 * 11);
  CHECK(mesh.texcoord2D(last)[0] == 0.3F);
  CHECK(mesh.property(quality, last) == 4);
}

TEST_CASE("OM: OpenMesh reads seams, closed meshes, boundaries and loose vertices") {
  const Folder folder;
  write_mesh(folder / "seam.om", square(), {}, {square_seam()});
  Mesh seam;
  OpenMesh::IO::Options options(OpenMesh::IO::Options::Binary | OpenMesh::IO::Options::FaceTexCoord);
  REQUIRE(OpenMesh::IO::read_mesh(seam, (folder / "seam.om").string(), options));
  for (const auto half : seam.fh_range(seam.face_handle(1)))
    if (half.to().idx() == 3) CHECK(seam.texcoord2D(half)[0] == 0.3F);

  IndexedMesh loose = square();
  loose.points.emplace_back(5, 5, 5);
  for (const IndexedMesh& mesh : {rounded(meshes::torus(7, 5)), rounded(meshes::cone(5, 1)), loose}) {
    write_mesh(folder / "a.om", mesh, {false, true});
    Mesh back;
    REQUIRE(OpenMesh::IO::read_mesh(back, (folder / "a.om").string()));
    CHECK(same_bits<double>(as_openmesh_has_it(back), mesh));
    CHECK(same_bits<double>(read_mesh(folder / "a.om").mesh, mesh));
  }
}

TEST_CASE("OM: what is not manifold goes in as lists of vertices, and OpenMesh reads it") {
  const Folder folder;
  IndexedMesh book = square();  // a third page at the diagonal
  book.points.emplace_back(0.5, 0.5, 1);
  book.triangles.push_back({0, 2, 4});
  const WriteReport report =
      write_mesh(folder / "a.om", book, {false, true},
                 {scalar("q", {1, 2, 3, 4, 5}), attribute(Kind::texture, 2, std::vector<float>(10))});
  CHECK(report.left_out == Names{"property 'q'"});
  const MeshFile file = read_mesh(folder / "a.om");
  CHECK(same_bits<double>(file.mesh, book));
  CHECK(file.attributes.size() == 1);
  CHECK(file.report.nonmanifold_edges == 1);
  Mesh mesh;
  REQUIRE(OpenMesh::IO::read_mesh(mesh, (folder / "a.om").string()));
  CHECK(mesh.n_faces() == 3);
}

/// An OM file by hand.
class OmBytes {
 public:
  OmBytes(char mesh, std::uint8_t version, std::uint32_t vertices, std::uint32_t faces, std::uint32_t edges) {
    bytes = std::string("OM") + mesh + static_cast<char>(version);
    for (const std::uint32_t count : {vertices, faces, edges}) append_little(bytes, count);
  }

  template <typename T>
  OmBytes& chunk(const ChunkHeader& header, const std::vector<T>& numbers) {
    append_little(bytes, header.pack());
    for (const T number : numbers) append_little(bytes, number);
    return *this;
  }
  OmBytes& end() {
    append_little(bytes, ChunkHeader{false, Entity::end, Type::position, false, false, 1, 0}.pack());
    return *this;
  }

  std::string bytes;
};

constexpr ChunkHeader points_header{false, Entity::vertex, Type::position, true, true, 3, 0};
const std::vector<float> four_points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

TEST_CASE("OM: polygons and quads of old files") {
  const Folder folder;
  OmBytes quads('Q', om::version(1, 2), 4, 1, 4);
  quads.chunk(points_header, four_points)
      .chunk<std::uint8_t>({false, Entity::face, Type::topology, false, false, 1, 0}, {0, 1, 2, 3});
  const MeshFile quad = folder.read("a.om", quads.bytes);
  CHECK(quad.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(quad.report.polygons == 1);

  OmBytes polygons('P', om::version(1, 2), 4, 2, 5);
  polygons.chunk(points_header, four_points)
      .chunk<std::uint16_t>({false, Entity::face, Type::topology, false, false, 1, 1},
                            {3, 0, 1, 2, 4, 3, 2, 1, 0})
      .end();
  CHECK(folder.read("a.om", polygons.bytes).mesh.triangles == Triangles{{0, 1, 2}, {3, 2, 1}, {3, 1, 0}});
  CHECK(folder.error("a.om", quads.bytes.substr(0, quads.bytes.size() - 1)) == "a.om: the file is cut off");
}

TEST_CASE("OM: deleted faces, and what is not read") {
  const Folder folder;
  OmBytes file('T', om::version(1, 2), 4, 2, 5);
  file.chunk(points_header, four_points)
      .chunk<std::uint32_t>({false, Entity::face, Type::topology, false, false, 1, 2}, {0, 1, 2, 0, 2, 3})
      .chunk<std::uint32_t>({false, Entity::face, Type::status, false, false, 1, 0}, {1, 0})
      .chunk<float>({false, Entity::face, Type::normal, true, true, 3, 0}, {0, 0, 1, 0, 0, 1})
      .end();
  const MeshFile read = folder.read("a.om", file.bytes + "x");
  CHECK(read.mesh.triangles == Triangles{{0, 2, 3}});
  CHECK(read.report.ignored ==
        Names{"faces marked as deleted", "status flags", "face normals", "bytes after the last chunk"});
}

TEST_CASE("OM: damaged files are refused with a message") {
  const Folder folder;
  const auto error = [&](const OmBytes& file) { return folder.error("a.om", file.bytes); };
  const ChunkHeader list{false, Entity::face, Type::topology, false, false, 1, 2};
  const std::uint8_t old = om::version(1, 2), now = om::version(2, 2);
  CHECK(folder.error("a.om", "OM") == "a.om: the file is cut off");
  CHECK(folder.error("a.om", std::string(16, 'x')) == "a.om: not an OM file: it does not begin with 'OM'");
  CHECK(error(OmBytes('X', old, 0, 0, 0)) == "a.om: unknown type of mesh 'X'");
  CHECK(error(OmBytes('T', om::version(3, 1), 0, 0, 0)) == "a.om: OM version 3.1 is not known");
  CHECK(error(OmBytes('T', now, 0, 0, 0)) == "a.om: the file is cut off");
  CHECK(error(OmBytes('T', old, 1, 0, 0)) == "a.om: the vertices lack their places");
  CHECK(error(OmBytes('T', old, 0, 1, 0)) == "a.om: the faces lack their vertices");
  CHECK(error(OmBytes('T', now, 0, 1, 0).chunk<std::uint32_t>(list, {0}).end()) ==
        "a.om: the half-edges are missing");
  CHECK(error(OmBytes('T', old, 4000000000U, 0, 0).chunk(points_header, four_points)) ==
        "a.om: the file is cut off");
  CHECK(error(OmBytes('T', old, 4, 1, 0)
                  .chunk(points_header, four_points)
                  .chunk<std::uint32_t>(list, {0, 1, 4})) ==
        "a.om: vertex index 4 is out of range: there are 4 vertices");
  CHECK(error(OmBytes('T', old, 1, 0, 0).chunk(points_header, std::vector<float>{0, NAN, 0})) ==
        "a.om: a coordinate is not finite");
  CHECK(
      error(OmBytes('T', old, 4, 0, 0).chunk(points_header, four_points).chunk(points_header, four_points)) ==
      "a.om: a second chunk of the same kind");
  CHECK(error(OmBytes('T', old, 0, 0, 0)
                  .chunk<char>({false, static_cast<Entity>(3), Type::normal, true, true, 3, 0}, {})) ==
        "a.om: a chunk of neither vertices nor faces nor edges");
  CHECK(error(OmBytes('T', old, 0, 0, 0)
                  .chunk<char>({false, Entity::vertex, static_cast<Type>(9), true, true, 3, 0}, {})) ==
        "a.om: a chunk of unknown type");
  OmBytes many('T', old, 0, 0, 0);
  for (int i = 0; i < 1001; ++i)
    many.chunk<char>({true, Entity::vertex, Type::custom, false, false, 1, 0}, {1, 'n', 0, 0, 0, 0});
  CHECK(error(many) == "a.om: the file has more than 1000 chunks");
}

TEST_CASE("OM: half-edges that make no loops") {
  const Folder folder;
  // next, to, face of each; a triangle and the way round it
  const std::vector<std::int32_t> good{2, 1, 0, 5, 0, -1, 4, 2, 0, 1, 1, -1, 0, 0, 0, 3, 2, -1};
  const auto file = [&](std::vector<std::int32_t> sides, std::int32_t first) {
    return OmBytes('T', om::version(2, 2), 4, 1, 3)
        .chunk(points_header, four_points)
        .chunk({false, Entity::halfedge, Type::topology, true, true, 3, 2}, sides)
        .chunk<std::int32_t>({false, Entity::face, Type::topology, true, true, 1, 2}, {first})
        .end()
        .bytes;
  };
  CHECK(folder.read("a.om", file(good, 4)).mesh.triangles == Triangles{{0, 1, 2}});
  const std::string no_loop = "a.om: the half-edges of face 0 do not make a loop of its own";
  CHECK(folder.error("a.om", file(good, 6)) == no_loop);
  CHECK(folder.error("a.om", file(good, -1)) == no_loop);
  for (const std::int32_t next : {-1, 2, 6, 1000000}) {
    std::vector<std::int32_t> bad = good;
    bad[6] = next;  // of the second half-edge of the face
    INFO(next);
    CHECK(folder.error("a.om", file(bad, 4)) == no_loop);
    const MeshFile fixed = folder.read("a.om", file(bad, 4), Repair::fix);
    CHECK(fixed.mesh.triangles.empty());
    CHECK(fixed.report.broken_faces == 1);
  }
  std::vector<std::int32_t> bad = good;
  bad[1] = 4;
  CHECK(folder.error("a.om", file(bad, 4)) == "a.om: vertex index 4 is out of range: there are 4 vertices");
}

}  // namespace
}  // namespace whittle::files
