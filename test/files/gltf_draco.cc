/// \file
/// glTF: parts packed by KHR_draco_mesh_compression.
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "gltf_samples.hh"
#include "meshes.hh"

namespace whittle::files {
namespace {

constexpr const char* kExtension = "KHR_draco_mesh_compression";

template <typename T>
int add_draco(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data, bool normalized,
              const std::vector<T>& values) {
  const std::size_t width = values.size() / mesh.num_points();
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<std::uint8_t>(width), data, normalized, sizeof(T) * width, 0);
  const int id = mesh.AddAttribute(attribute, true, mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &values[i * width]);
  return id;
}

std::string packed_by_draco(const draco::Mesh& mesh, int method) {
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer bytes;
  REQUIRE(encoder.EncodeToBuffer(&bytes).ok());
  return {bytes.data(), bytes.size()};
}

/// A torus with normals, colours of bytes and texture coordinates that are quantised by 16 bits, and its document.
struct DracoTorus {
  IndexedMesh mesh = rounded(meshes::torus(12, 8));
  draco::Mesh packed;
  GltfBuilder built;

  explicit DracoTorus(int method = draco::MESH_EDGEBREAKER_ENCODING) {
    packed.set_num_points(static_cast<std::uint32_t>(mesh.points.size()));
    for (const auto& t : mesh.triangles)
      packed.AddFace({draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
    std::vector<float> points, normals;
    std::vector<std::uint8_t> colours;
    std::vector<std::uint16_t> texture;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      for (const double x : mesh.points[i]) points.push_back(static_cast<float>(x));
      normals.insert(normals.end(), {0, i % 2 ? 1.0F : -1.0F, 0});
      colours.insert(colours.end(), {static_cast<std::uint8_t>(i), 7, 255, 40});
      texture.insert(texture.end(), {static_cast<std::uint16_t>(600 * i), 65535});
    }
    const int ids[] = {
        add_draco(packed, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, false, points),
        add_draco(packed, draco::GeometryAttribute::NORMAL, draco::DT_FLOAT32, false, normals),
        add_draco(packed, draco::GeometryAttribute::COLOR, draco::DT_UINT8, true, colours),
        // As whole numbers, which the accessor takes for floats.
        add_draco(packed, draco::GeometryAttribute::TEX_COORD, draco::DT_UINT16, true, texture)};
    const char* const names[] = {"POSITION", "NORMAL", "COLOR_0", "TEXCOORD_0"};
    Json attributes, numbers;
    for (int i = 0; i < 4; ++i) {
      const bool bytes = i == 2;
      built.json["accessors"].push_back({{"componentType", bytes ? 5121 : 5126},
                                         {"normalized", bytes},
                                         {"type", i < 2 ? "VEC3" : (i == 2 ? "VEC4" : "VEC2")},
                                         {"count", mesh.points.size()}});
      attributes[names[i]] = i;
      numbers[names[i]] = packed.attribute(ids[i])->unique_id();
    }
    built.json["accessors"].push_back(
        {{"componentType", 5125}, {"type", "SCALAR"}, {"count", 3 * mesh.triangles.size()}});
    const int view = built.view(packed_by_draco(packed, method));
    built.json["meshes"] = {
        {{"primitives",
          {{{"attributes", attributes},
            {"indices", 4},
            {"extensions", {{kExtension, {{"bufferView", view}, {"attributes", numbers}}}}}}}}}};
    built.json["nodes"] = {{{"mesh", 0}, {"name", "ring"}}};
    built.json["scenes"] = {{{"nodes", {0}}}};
    built.json["extensionsUsed"] = {kExtension};
    built.json["extensionsRequired"] = {kExtension};
  }

  Json& part() { return built.json["meshes"][0]["primitives"][0]; }
  Json& extension() { return part()["extensions"][kExtension]; }

  /// What its faces have at their corners; see corners_of().
  std::vector<std::string> corners() const {
    std::vector<std::string> faces;
    for (const auto& t : mesh.triangles) {
      std::vector<std::string> corners;
      for (const std::uint32_t v : t)
        corners.push_back(text_of(mesh.points[v], static_cast<int>(v), v % 2 ? 1 : -1, 600 * v / 65535.0));
      faces.push_back(turned(corners));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  static std::string text_of(const IndexedMesh::Point& point, int red, double normal, double u) {
    std::string text;
    for (const double x : point) text += std::to_string(x) + " ";
    return text + std::to_string(red) + " " + std::to_string(normal) + " " + std::to_string(u) + ";";
  }

  /// The same whichever corner comes first.
  static std::string turned(std::vector<std::string> corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners[0] + corners[1] + corners[2];
  }
};

/// Of each face the corners' coordinates and values; in an order of their own, as Draco changes that of vertices and faces.
std::vector<std::string> corners_of(const MeshFile& file) {
  const auto kind = [&](Kind of) -> const Attribute& {
    for (const Attribute& one : file.attributes)
      if (one.kind == of) return one;
    throw FileError("the attribute is not there");
  };
  const Attribute &normal = kind(Kind::normal), &colour = kind(Kind::colour), &texture = kind(Kind::texture);
  std::vector<std::string> faces;
  for (std::size_t f = 0; f < file.mesh.triangles.size(); ++f) {
    std::vector<std::string> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners.push_back(DracoTorus::text_of(
          file.mesh.points[file.mesh.triangles[f][k]],
          static_cast<int>(std::lround(255 * colour.value(colour.at(file.mesh, f, k))[0])),
          static_cast<double>(normal.value(normal.at(file.mesh, f, k))[1]),
          static_cast<double>(texture.value(texture.at(file.mesh, f, k))[0])));
    faces.push_back(DracoTorus::turned(corners));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The message for the torus after a change.
std::string draco_error(const std::function<void(DracoTorus&)>& change) {
  const Folder folder;
  DracoTorus torus;
  change(torus);
  return folder.error("a.gltf", gltf_text(torus.built.json));
}

/// The torus' document with other bytes for its packed part.
std::string with_packed(const std::string& bytes) {
  DracoTorus torus;
  torus.extension()["bufferView"] = torus.built.view(bytes);
  return gltf_text(torus.built.json);
}

}  // namespace

TEST_CASE("Draco: a part is read with all of its attributes, however it was packed") {
  const Folder folder;
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
    const DracoTorus torus(method);
    const MeshFile file = folder.read("a.gltf", gltf_text(torus.built.json));
    CHECK(file.mesh.points.size() == torus.mesh.points.size());
    CHECK(corners_of(file) == torus.corners());
    CHECK(file.report.ignored.empty());
  }
}

TEST_CASE("Draco: a scene comes through unpacked, and does not name the extension any more") {
  const Folder folder;
  const DracoTorus torus;
  folder.put("a.gltf", gltf_text(torus.built.json));
  ReadOptions options;
  options.keep_scene = true;
  const MeshFile file = read_mesh(folder / "a.gltf", options);
  std::vector<std::uint32_t> same(file.mesh.points.size());
  std::iota(same.begin(), same.end(), 0U);
  const Encoded out =
      encode_scene(folder / "b.glb", file, {file.mesh, file.attributes, file.parts.of_face, same});
  const Json json = json_of(out.bytes);
  CHECK_FALSE(json.contains("extensionsUsed"));
  CHECK_FALSE(json.contains("extensionsRequired"));
  CHECK_FALSE(json["meshes"][0]["primitives"][0].contains("extensions"));
  CHECK(json["nodes"][0]["name"] == "ring");
  CHECK(corners_of(folder.read("b.glb", out.bytes)) == torus.corners());
}

TEST_CASE("Draco: what is there unpacked as well is taken as it is") {
  const Folder folder;
  GltfBuilder built;
  built.json = gltf_square();
  Json& part = built.json["meshes"][0]["primitives"][0];
  part["extensions"][kExtension] = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  CHECK(same_bits<double>(folder.read("a.gltf", gltf_text(built.json)).mesh, square()));
}

TEST_CASE("Draco: parts that are wrong are refused") {
  const auto wrong = [](const std::string& what) {
    return "a.gltf: its JSON is damaged: wrong '" + what + "' of a part packed by KHR_draco_mesh_compression";
  };
  CHECK(draco_error([](DracoTorus&) {}).empty());
  CHECK(draco_error([](DracoTorus& t) { t.extension() = 7; }) == wrong("bufferView"));
  CHECK(draco_error([](DracoTorus& t) { t.extension()["bufferView"] = 1; }) ==
        "a.gltf: a view that is not there");
  CHECK(draco_error([](DracoTorus& t) { t.extension().erase("attributes"); }) == wrong("attributes"));
  CHECK(draco_error([](DracoTorus& t) { t.extension()["attributes"]["POSITION"] = 77; }) ==
        wrong("attributes"));
  CHECK(draco_error([](DracoTorus& t) { t.extension()["attributes"]["TEXCOORD_1"] = 0; }) ==
        wrong("attributes"));
  CHECK(draco_error([](DracoTorus& t) { t.built.json["accessors"][0]["type"] = "VEC2"; }) ==
        wrong("attributes"));
  CHECK(draco_error([](DracoTorus& t) { t.part()["mode"] = 1; }) == wrong("mode"));
  CHECK(draco_error([](DracoTorus& t) { t.built.json["bufferViews"][0]["byteLength"] = 50; }) ==
        "a.gltf: its data are damaged: a part packed by KHR_draco_mesh_compression");
  CHECK(draco_error([](DracoTorus& t) { t.built.json["accessors"][0]["componentType"] = 5121; }) ==
        "a.gltf: its data are damaged: a value that does not fit its accessor");
}

TEST_CASE("Draco: data of no mesh, of another version and of absurd counts are refused") {
  const Folder folder;
  const std::string damaged = "a.gltf: its data are damaged: a part packed by KHR_draco_mesh_compression";
  const std::string too_large = "a.gltf: the scene is too many times as large as the file";
  const auto error = [&](const std::string& bytes) { return folder.error("a.gltf", with_packed(bytes)); };
  const auto stream = [](int version, int type, int method, const std::string& rest) {
    return std::string("DRACO\2") + static_cast<char>(version) + static_cast<char>(type) +
           static_cast<char>(method) + std::string(2, '\0') + rest;
  };
  const std::string huge = "\xff\xff\xff\xff\4";  // as a varint, 1.3 thousand million
  const std::string padding(200, '\0');
  CHECK(error("DRAGO and more") == damaged);
  CHECK(error(stream(1, 1, 1, padding)) ==
        "a.gltf: a part packed by version 2.1 of Draco's format; glTF has version 2.2");
  CHECK(error(stream(2, 0, 1, padding)) == damaged);
  CHECK(error(stream(2, 1, 2, padding)) == damaged);
  // A million faces, each of which may be a byte; and as many attributes with corner tables of their own.
  CHECK(error(stream(2, 1, 1, std::string(1, '\0') + "\3" + huge + padding)) == too_large);
  CHECK(error(stream(2, 1, 1, std::string(1, '\0') + "\3\x80\x80\x20\xff" + padding)) == too_large);
  CHECK(error(stream(2, 1, 0, huge + "\3" + padding)) == too_large);
}

TEST_CASE("Draco: with any byte changed or cut off it is read or refused") {
  const Folder folder;
  const DracoTorus torus;
  const std::string good = packed_by_draco(torus.packed, draco::MESH_EDGEBREAKER_ENCODING);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < good.size(); i += 3) {
    std::string bytes = good;
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << i % 8));
    refused += !folder.error("a.gltf", with_packed(bytes)).empty();
    refused += !folder.error("a.gltf", with_packed(good.substr(0, i))).empty();
  }
  CHECK(refused > good.size() / 3);
}

}  // namespace whittle::files
