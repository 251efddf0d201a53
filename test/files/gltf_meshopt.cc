/// \file
/// glTF: views packed by EXT_meshopt_compression, in each of its modes and with each of its filters.
#include <meshoptimizer.h>

#include <algorithm>

#include "gltf_samples.hh"
#include "meshes.hh"

namespace whittle::files {
namespace {

using Bytes = std::vector<unsigned char>;

template <typename T>
Bytes packed_values(const std::vector<T>& values, std::size_t stride) {
  const std::size_t count = values.size() * sizeof(T) / stride;
  Bytes out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), values.data(), count, stride));
  return out;
}

/// A document with packed views.
struct MeshoptBuilder : GltfBuilder {
  /// \return the accessor of the values
  int packed(const Bytes& bytes, std::size_t count, std::size_t stride, const char* mode, const char* filter,
             int component_type, const char* type) {
    const int view = this->view(std::string(bytes.begin(), bytes.end()));
    Json& plain = json["bufferViews"][static_cast<std::size_t>(view)];
    plain["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                      {"byteOffset", plain["byteOffset"]},
                                                      {"byteLength", bytes.size()},
                                                      {"byteStride", stride},
                                                      {"count", count},
                                                      {"mode", mode},
                                                      {"filter", filter}};
    if (std::string(mode) == "ATTRIBUTES") plain["byteStride"] = stride;
    const int number = accessor(view, component_type, type, count);
    json["accessors"][static_cast<std::size_t>(number)]["normalized"] = component_type < 5125;
    return number;
  }

  int packed_floats(const std::vector<float>& values, std::size_t width, const char* type) {
    return packed(packed_values(values, 4 * width), values.size() / width, 4 * width, "ATTRIBUTES", "NONE",
                  5126, type);
  }
};

/// The vertices of a mesh as floats, and its corners.
std::vector<float> coordinates_of(const IndexedMesh& mesh) {
  std::vector<float> values;
  for (const IndexedMesh::Point& point : mesh.points)
    for (const double x : point) values.push_back(static_cast<float>(x));
  return values;
}
std::vector<std::uint32_t> corners_in(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  return corners;
}

/// With the smallest corner first; packed triangles keep their sense only.
Triangles turned(Triangles triangles) {
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return triangles;
}

/// A triangle for each three values of an attribute, read back.
std::vector<float> read_values(MeshoptBuilder& built, const std::string& name, int accessor,
                               std::size_t count) {
  std::vector<float> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    points.insert(points.end(), {x, x * x, -x});
  }
  built.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", built.packed_floats(points, 3, "VEC3")}, {name, accessor}}}}}}}};
  built.json["nodes"] = {{{"mesh", 0}}};
  const Folder folder;
  folder.put("a.gltf", gltf_text(built.json));
  ReadOptions options;
  options.keep_scene = true;
  const MeshFile file = read_mesh(folder / "a.gltf", options);
  REQUIRE(file.attributes.size() == 1);
  CHECK(file.attributes[0].n_values() == count);
  return file.attributes[0].values;
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  return largest;
}

}  // namespace

TEST_CASE("meshopt: positions, and indices of triangles and in sequence, come back as they were") {
  const Folder folder;
  const IndexedMesh mesh = rounded(meshes::torus(12, 8));
  const std::vector<std::uint32_t> corners = corners_in(mesh);
  const std::vector<std::uint16_t> narrow(corners.begin(), corners.end());
  const std::size_t vertices = mesh.points.size();
  for (const bool in_sequence : {false, true})
    for (const std::size_t stride : {2, 4}) {
      MeshoptBuilder built;
      const int points = built.packed_floats(coordinates_of(mesh), 3, "VEC3");
      Bytes bytes(in_sequence ? meshopt_encodeIndexSequenceBound(corners.size(), vertices)
                              : meshopt_encodeIndexBufferBound(corners.size(), vertices));
      bytes.resize(
          in_sequence
              ? meshopt_encodeIndexSequence(bytes.data(), bytes.size(), corners.data(), corners.size())
              : meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), corners.data(), corners.size()));
      const int indices = built.packed(bytes, corners.size(), stride, in_sequence ? "INDICES" : "TRIANGLES",
                                       "NONE", stride == 2 ? 5123 : 5125, "SCALAR");
      built.json["accessors"][1].erase("normalized");
      built.json["meshes"] = {
          {{"primitives", {{{"attributes", {{"POSITION", points}}}, {"indices", indices}}}}}};
      built.json["extensionsRequired"] = {"EXT_meshopt_compression"};
      const MeshFile file = folder.read("a.gltf", gltf_text(built.json));
      CHECK(file.mesh.points == mesh.points);
      if (in_sequence)
        CHECK(file.mesh.triangles == mesh.triangles);
      else
        CHECK(turned(file.mesh.triangles) == turned(mesh.triangles));
    }
}

TEST_CASE("meshopt: the octahedral filter gives normals of 8 and of 16 bits") {
  const std::vector<float> normals = {1,     0,     0,     0, 0, -1,   0,    0, 0, 0, -1, 0,
                                      0.48F, -0.6F, 0.64F, 0, 0, 0.6F, 0.8F, 0, 0, 0, 1,  0};
  std::vector<float> expected;
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (i % 4 < 3) expected.push_back(normals[i]);
  for (const std::size_t stride : {4, 8}) {
    std::vector<unsigned char> filtered(6 * stride);
    const int bits = stride == 4 ? 8 : 16;
    meshopt_encodeFilterOct(filtered.data(), 6, stride, bits, normals.data());
    MeshoptBuilder built;
    const int accessor = built.packed(packed_values(filtered, stride), 6, stride, "ATTRIBUTES", "OCTAHEDRAL",
                                      stride == 4 ? 5120 : 5122, "VEC3");
    const std::vector<float> back = read_values(built, "NORMAL", accessor, 6);
    CHECK(largest_difference(back, expected) < 1.5 / (stride == 4 ? 127 : 32767));
    CHECK(back[0] == 1);
  }
}

TEST_CASE("meshopt: the quaternion filter") {
  std::vector<float> turns = {0, 0, 0, 1, 0.6F, 0, 0.8F, 0, 0.5F, -0.5F, 0.5F, 0.5F};
  std::vector<unsigned char> filtered(3 * 8);
  meshopt_encodeFilterQuat(filtered.data(), 3, 8, 16, turns.data());
  MeshoptBuilder built;
  const int accessor =
      built.packed(packed_values(filtered, 8), 3, 8, "ATTRIBUTES", "QUATERNION", 5122, "VEC4");
  std::vector<float> back = read_values(built, "_TURN", accessor, 3);
  // A quaternion and its negative are the same turn.
  for (std::size_t i = 0; i < 12; i += 4) {
    double product = 0;
    for (std::size_t k = 0; k < 4; ++k)
      product += static_cast<double>(back[i + k]) * static_cast<double>(turns[i + k]);
    for (std::size_t k = 0; k < 4 && product < 0; ++k) back[i + k] = -back[i + k];
  }
  CHECK(largest_difference(back, turns) < 2.0 / 32767);
}

TEST_CASE("meshopt: the exponential filter keeps what has few bits") {
  const std::vector<float> values = {0.5F, -2.75F, 1024, 0.001F, 0, -7, 3, 1.0F / 1024, 12};
  std::vector<unsigned char> filtered(3 * 12);
  meshopt_encodeFilterExp(filtered.data(), 3, 12, 15, values.data());
  MeshoptBuilder built;
  const int accessor =
      built.packed(packed_values(filtered, 12), 3, 12, "ATTRIBUTES", "EXPONENTIAL", 5126, "VEC3");
  const std::vector<float> back = read_values(built, "_SPEED", accessor, 3);
  CHECK(back[0] == 0.5F);
  CHECK(back[5] == -7);
  CHECK(largest_difference(back, values) < 1024.0 / (1 << 14));
}

TEST_CASE("meshopt: modes, filters and counts that do not fit are refused") {
  const Folder folder;
  const auto error = [&](const char* key, const Json& value) {
    MeshoptBuilder built;
    built.json["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", built.packed_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3, "VEC3")}}}}}}}};
    if (*key) built.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
    return folder.error("a.gltf", gltf_text(built.json));
  };
  const std::string damaged = "a.gltf: its data are damaged: a view packed by EXT_meshopt_compression";
  CHECK(error("", 0).empty());
  CHECK(error("mode", "VERTICES") == damaged);
  CHECK(error("mode", "TRIANGLES") == damaged);
  CHECK(error("filter", "OCTAHEDRAL") == damaged);
  CHECK(error("filter", "QUATERNION") == damaged);
  CHECK(error("byteStride", 10) == damaged);
  CHECK(error("byteLength", 5) == damaged);
  CHECK(error("byteLength", 5000) == "a.gltf: the file is cut off: a view reaches beyond its buffer");
  CHECK(error("buffer", 3) == "a.gltf: the file is cut off: a view reaches beyond its buffer");
  CHECK(error("count", 1000000000) == "a.gltf: the scene is too many times as large as the file");
}

}  // namespace whittle::files
