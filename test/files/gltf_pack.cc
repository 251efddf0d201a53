/// \file
/// glTF made small: rounded by KHR_mesh_quantization, packed by EXT_meshopt_compression.
#include <algorithm>
#include <numeric>

#include "gltf_samples.hh"
#include "meshes.hh"

namespace whittle::files {
namespace {

WriteOptions packing(int bits, bool meshopt) {
  WriteOptions options;
  options.quantize = bits;
  options.meshopt = meshopt;
  return options;
}

/// For each vertex of a file read back the vertex of the mesh; the identity where they are the same.
std::size_t vertex_in(const MeshFile& back, std::size_t in_file) {
  return back.vertex_of.empty() ? in_file : back.vertex_of[in_file];
}

/// How far a mesh's vertices lie from where the file has them, coordinate by coordinate.
double largest_move(const IndexedMesh& mesh, const MeshFile& back, const WriteReport& report) {
  double largest = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::size_t in_file = report.first_vertex.empty() ? v : report.first_vertex[v];
    largest = std::max(largest,
                       (back.mesh.points[vertex_in(back, in_file)] - mesh.points[v]).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The faces by the places of their corners, whichever comes first; in an order of their own.
std::vector<std::vector<double>> faces_by_place(const IndexedMesh& mesh) {
  std::vector<std::vector<double>> faces;
  for (const auto& t : mesh.triangles) {
    const auto place = [&](std::size_t k) {
      const IndexedMesh::Point& p = mesh.points[t[k % 3]];
      return std::vector<double>{p.x(), p.y(), p.z()};
    };
    std::size_t first = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (place(k) < place(first)) first = k;
    std::vector<double> face;
    for (std::size_t k = 0; k < 3; ++k)
      for (const double x : place(first + k)) face.push_back(x);
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

double extent_of(const IndexedMesh& mesh) {
  IndexedMesh::Point low = mesh.points[0], high = low;
  for (const auto& p : mesh.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

/// A torus with normals and texture coordinates that are 0..1.
struct DressedTorus {
  IndexedMesh mesh = rounded(meshes::torus(24, 16));
  Attributes attributes;

  DressedTorus() {
    std::vector<float> normals, texture;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const double angle = 0.1 * static_cast<double>(i);
      normals.insert(normals.end(),
                     {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
      texture.insert(texture.end(), {static_cast<float>(i) / 400, 1 - static_cast<float>(i % 7) / 6});
    }
    attributes = {attribute(Kind::normal, 3, normals), attribute(Kind::texture, 2, texture)};
  }
};

std::string message_with(const WriteReport& report, const std::string& begin) {
  for (const std::string& line : report.reduced)
    if (line.rfind(begin, 0) == 0) return line;
  return {};
}

}  // namespace

TEST_CASE("quantize: positions come back within half a step, normals and texture coordinates too") {
  const Folder folder;
  const DressedTorus torus;
  for (const int bits : {16, 12, 8}) {
    const Encoded out = encode_mesh("a.glb", torus.mesh, packing(bits, false), torus.attributes);
    const MeshFile back = folder.read("a.glb", out.bytes);
    const double step = extent_of(torus.mesh) / (std::exp2(bits) - 1);
    CHECK(back.mesh.triangles == torus.mesh.triangles);
    const double move = largest_move(torus.mesh, back, out.report);
    CHECK(move <= 0.5001 * step);
    CHECK(move > 0.2 * step);
    CHECK_FALSE(message_with(out.report, "positions rounded to " + std::to_string(bits) + " bits, by up to ")
                    .empty());
    CHECK_FALSE(message_with(out.report, "normals or tangents rounded to 8 bits, by up to 0.").empty());
    CHECK(message_with(out.report, "texture coordinates rounded to 16 bits, by up to 7.") != "");

    const Attribute &normal = find(back.attributes, Kind::normal),
                    &texture = find(back.attributes, Kind::texture);
    double turned = 0, moved = 0;
    for (std::size_t i = 0; i < normal.values.size(); ++i)
      turned =
          std::max(turned, static_cast<double>(std::abs(normal.values[i] - torus.attributes[0].values[i])));
    for (std::size_t v = 0; v < torus.mesh.points.size(); ++v) {
      moved = std::max(moved,
                       static_cast<double>(std::abs(texture.value(v)[0] - torus.attributes[1].value(v)[0])));
      moved = std::max(
          moved, static_cast<double>(std::abs(texture.value(v)[1] - (1 - torus.attributes[1].value(v)[1]))));
    }
    CHECK(turned <= 1.0 / 127);
    CHECK(moved <= 0.51 / 65535);
  }
}

TEST_CASE("quantize: the document says how it is to be read") {
  const DressedTorus torus;
  const Json json = json_of(encode_mesh("a.glb", torus.mesh, packing(16, false), torus.attributes).bytes);
  CHECK(json["extensionsRequired"] == Json{"KHR_mesh_quantization"});
  CHECK(json["extensionsUsed"] == Json{"KHR_mesh_quantization"});
  const Json& part = json["meshes"][0]["primitives"][0]["attributes"];
  const auto accessor = [&](const char* name) { return json["accessors"][part[name].get<std::size_t>()]; };
  const auto stride = [&](const char* name) {
    return json["bufferViews"][accessor(name)["bufferView"].get<std::size_t>()].value("byteStride", 0);
  };
  CHECK(accessor("POSITION")["componentType"] == 5123);
  CHECK(stride("POSITION") == 8);
  CHECK(accessor("POSITION")["min"] == Json{0, 0, 0});
  CHECK(accessor("POSITION")["max"][0] == 65535);
  CHECK(accessor("NORMAL")["componentType"] == 5120);
  CHECK(accessor("NORMAL")["normalized"] == true);
  CHECK(stride("NORMAL") == 4);
  CHECK(accessor("TEXCOORD_0")["componentType"] == 5123);
  CHECK(accessor("TEXCOORD_0")["normalized"] == true);
  CHECK(json["nodes"].size() == 1);
  CHECK(json["nodes"][0]["scale"][0].get<double>() == Approx(extent_of(torus.mesh) / 65535));
}

TEST_CASE("quantize: a place far from the origin and a flat mesh of one point") {
  const Folder folder;
  IndexedMesh far = meshes::torus(12, 8);
  for (auto& point : far.points) point += IndexedMesh::Point(500000, 5000000, 0);
  const Encoded out = encode_mesh("a.glb", far, packing(16, false));
  CHECK(largest_move(far, folder.read("a.glb", out.bytes), out.report) < 0.51 * extent_of(far) / 65535);
  IndexedMesh dot;
  dot.points = {{1, 2, 3}};
  CHECK(folder.read("b.glb", encode_mesh("b.glb", dot, packing(16, true)).bytes).mesh.points == dot.points);
}

TEST_CASE("quantize: texture coordinates beyond 0..1 stay floats, and that is said") {
  const Folder folder;
  Attribute texture = square_texture();
  texture.values[2] = 1.5F;
  const Encoded out = encode_mesh("a.glb", square(), packing(16, false), {texture});
  CHECK(message_with(out.report, "texture") == "texture coordinates beyond 0..1 stay 32-bit floats");
  CHECK(find(folder.read("a.glb", out.bytes).attributes, Kind::texture).values[2] == 1.5F);
}

TEST_CASE("meshopt: a mesh comes back as it was, in another order, smaller, and the report follows") {
  const Folder folder;
  const DressedTorus torus;
  const Encoded plain = encode_mesh("a.glb", torus.mesh, {}, torus.attributes);
  const Encoded out = encode_mesh("a.glb", torus.mesh, packing(0, true), torus.attributes);
  CHECK(out.report.reduced.empty());
  CHECK(out.bytes.size() < plain.bytes.size());
  const MeshFile back = folder.read("a.glb", out.bytes);
  CHECK(faces_by_place(back.mesh) == faces_by_place(torus.mesh));
  CHECK(largest_move(torus.mesh, back, out.report) == 0);
  const Attribute& normal = find(back.attributes, Kind::normal);
  for (std::size_t v = 0; v < torus.mesh.points.size(); ++v)
    REQUIRE(normal.value(vertex_in(back, out.report.first_vertex[v]))[1] == torus.attributes[0].value(v)[1]);

  const Json json = json_of(out.bytes);
  CHECK(json["extensionsRequired"] == Json{"EXT_meshopt_compression"});
  REQUIRE(json["buffers"].size() == 2);
  CHECK(json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"] == true);
  CHECK_FALSE(json["buffers"][1].contains("uri"));
}

TEST_CASE("meshopt and quantize: .gltf, materials of their own, vertices of no face, levels") {
  const Folder folder;
  IndexedMesh mesh = square();
  mesh.points.emplace_back(0.25, 0.5, 0.5);
  Parts parts;
  parts.materials.resize(2);
  parts.list = {{0, "", "", ""}, {1, "", "", ""}};
  parts.of_face = {0, 1};
  for (const char* name : {"a.gltf", "a.glb"}) {
    const WriteReport report = write_mesh(folder / name, mesh, packing(16, true), {}, parts);
    const MeshFile back = read_mesh(folder / name);
    CHECK(back.mesh.triangles.size() == 2);
    CHECK(back.parts.materials.size() == 2);
    for (std::size_t v = 0; v < 4; ++v)
      CHECK((back.mesh.points[vertex_in(back, report.first_vertex[v])] - mesh.points[v]).norm() < 1e-5);
  }
  CHECK(folder.read("b.glb", encode_mesh("b.glb", mesh, packing(0, true)).bytes).mesh.points.size() == 4);

  const DressedTorus torus;
  const std::vector<Level> levels{{torus.mesh, torus.attributes, {}, 0}, {square(), {}, {}, 1}};
  const Encoded out = encode_levels("c.glb", levels, packing(16, true));
  const MeshFile first = folder.read("c.glb", out.bytes);
  CHECK(largest_move(torus.mesh, first, out.report) < 0.51 * extent_of(torus.mesh) / 65535);
  CHECK(json_of(out.bytes)["nodes"][1]["scale"][0].get<double>() == Approx(1 / 65535.0));
}

TEST_CASE("quantize: in a scene nodes keep what is said of them, and get a child for it") {
  const Folder folder;
  Json json = gltf_square();
  // A shift of the vertices, shown by two nodes; one is moved, and its weight is animated.
  const std::vector<float> shift = {0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4}, times = {0, 1}, weights = {0, 1};
  std::string bytes;
  for (const auto* values : {&shift, &times, &weights})
    for (const float value : *values) append_little(bytes, value);
  json["buffers"].push_back(
      {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
  const std::size_t begin[] = {0, 48, 56}, length[] = {48, 8, 8};
  for (int i = 0; i < 3; ++i) {
    json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", begin[i]}, {"byteLength", length[i]}});
    json["accessors"].push_back({{"bufferView", 3 + i},
                                 {"componentType", 5126},
                                 {"type", i == 0 ? "VEC3" : "SCALAR"},
                                 {"count", i == 0 ? 4 : 2}});
  }
  json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 3}}};
  json["nodes"] = {{{"mesh", 0}, {"name", "one"}},
                   {{"mesh", 0}, {"name", "two"}, {"translation", {5, 0, 0}}, {"weights", {0.5}}}};
  json["scenes"][0]["nodes"] = {0, 1};
  json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}}}},
                         {"samplers", {{{"input", 4}, {"output", 5}}}}}};
  folder.put("a.gltf", gltf_text(json));
  ReadOptions keeping;
  keeping.keep_scene = true;
  const MeshFile file = read_mesh(folder / "a.gltf", keeping);
  std::vector<std::uint32_t> same(file.mesh.points.size());
  std::iota(same.begin(), same.end(), 0U);
  const SceneResult result{file.mesh, file.attributes, file.parts.of_face, same};
  const Encoded out = encode_scene(folder / "b.glb", file, result, packing(16, true));
  const Json after = json_of(out.bytes);
  REQUIRE(after["nodes"].size() == 4);
  CHECK(after["nodes"][1]["name"] == "two");
  CHECK(after["nodes"][1]["translation"] == Json{5, 0, 0});
  CHECK(after["nodes"][1]["children"] == Json{3});
  CHECK_FALSE(after["nodes"][1].contains("mesh"));
  CHECK(after["nodes"][3]["weights"] == Json{0.5});
  CHECK(after["animations"][0]["channels"][0]["target"]["node"] == 3);

  const MeshFile flat = folder.read("b.glb", out.bytes), before = read_mesh(folder / "a.gltf");
  REQUIRE(flat.mesh.points.size() == 8);
  for (const auto& point : before.mesh.points) {
    double nearest = 1;
    for (const auto& other : flat.mesh.points) nearest = std::min(nearest, (point - other).norm());
    CHECK(nearest < 1e-4);  // the shifts are four times as large as the square: so is a step
  }
  folder.put("b.glb", out.bytes);
  const MeshFile kept = read_mesh(folder / "b.glb", keeping);
  const Attribute& moved = find(kept.attributes, Kind::vector, "0/POSITION");
  const double step = after["nodes"][3]["scale"][0].get<double>();
  std::vector<double> shifts;
  shifts.reserve(moved.n_values());
  for (std::size_t i = 0; i < moved.n_values(); ++i)
    shifts.push_back(step * static_cast<double>(moved.value(i)[2]));
  std::sort(shifts.begin(), shifts.end());
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(shifts[i] - static_cast<double>(i + 1)) <= 0.51 * step);
}

TEST_CASE("quantize: a mesh with a skin keeps its floats, and that is said") {
  const Folder folder;
  Json json = gltf_square();
  json["nodes"][0]["skin"] = 0;
  json["nodes"].push_back({{"name", "joint"}});
  json["skins"] = {{{"joints", {1}}}};
  folder.put("a.gltf", gltf_text(json));
  ReadOptions keeping;
  keeping.keep_scene = true;
  const MeshFile file = read_mesh(folder / "a.gltf", keeping);
  const Encoded out = encode_scene(folder / "b.glb", file,
                                   {file.mesh, file.attributes, file.parts.of_face, {}}, packing(16, false));
  CHECK(message_with(out.report, "positions") == "positions of a mesh that has a skin stay 32-bit floats");
  const Json after = json_of(out.bytes);
  const Json& part = after["meshes"][0]["primitives"][0]["attributes"];
  CHECK(after["accessors"][part["POSITION"].get<std::size_t>()]["componentType"] == 5126);
  CHECK(after["accessors"][part["NORMAL"].get<std::size_t>()]["componentType"] == 5120);
}

}  // namespace whittle::files
