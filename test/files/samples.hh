/// \file
/// A folder for the files of one test, and small meshes to put in it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "Folder.hh"
#include "files/MeshFile.hh"

namespace whittle::files {

using Triangles = std::vector<IndexedMesh::Triangle>;
using Names = std::vector<std::string>;
using attributes::Attribute;
using attributes::Attributes;
using attributes::Kind;

/// A folder to put files into and read them from.
class Folder : public scratch::Folder {
 public:
  /// Puts a file there and reads it as a mesh.
  MeshFile read(const std::string& name, const std::string& bytes, Repair repair = Repair::report) const {
    put(name, bytes);
    return read_mesh(*this / name, {repair});
  }

  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(*this / name, std::ios::binary) << bytes;
  }

  std::string get(const std::string& name) const { return scratch::contents(*this / name); }

  /// The message with which reading fails, from behind the folder's name: "a.obj:3: what".
  std::string error(const std::string& name, const std::string& bytes, Repair repair = Repair::report) const {
    put(name, bytes);
    return message([&] { read_mesh(*this / name, {repair}); });
  }

  /// Writes a mesh, and reads it again.
  MeshFile there_and_back(const std::string& name, const IndexedMesh& mesh, const Attributes& attributes,
                          const WriteOptions& options = {}) const {
    write_mesh(*this / name, mesh, options, attributes);
    return read_mesh(*this / name);
  }

  /// The message of the FileError that an action throws, without this folder's name; empty if it throws none.
  template <typename Action>
  std::string message(Action action) const {
    try {
      action();
    } catch (const FileError& error) {
      const std::string text = error.what();
      const std::string prefix = path().string() + "/";
      return text.rfind(prefix, 0) == 0 ? text.substr(prefix.size()) : text;
    }
    return {};
  }
};

/// Exact to the last bit of Real: the sign of zero counts.
template <typename Real>
bool same_bits(const IndexedMesh& a, const IndexedMesh& b) {
  if (a.points.size() != b.points.size() || a.triangles != b.triangles) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Real x = static_cast<Real>(a.points[i][k]);
      const Real y = static_cast<Real>(b.points[i][k]);
      if (x != y || std::signbit(x) != std::signbit(y)) return false;
    }
  return true;
}

/// Points (i, i²/1e7, -i/3) and a strip of triangles over them: every digit of the coordinates matters.
/// \tparam Real  the precision of the coordinates; float arithmetic, because GCC 12 drops a conversion from
///               double to float and back when it vectorizes
template <typename Real>
IndexedMesh strip(std::uint32_t vertices) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const Real x = static_cast<Real>(i);
    mesh.points.emplace_back(x, x * x / Real(1e7), -x / 3);
  }
  for (std::uint32_t i = 0; i + 2 < vertices; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

/// As 32-bit floats have it.
inline IndexedMesh rounded(IndexedMesh mesh) {
  for (IndexedMesh::Point& point : mesh.points) {
    for (double& value : point) {
      const volatile float narrow =
          static_cast<float>(value);  // GCC 12 drops the conversion when it vectorizes
      value = narrow;
    }
  }
  return mesh;
}

/// With a value for each vertex, or for what `corners` name.
inline Attribute attribute(Kind kind, std::size_t components, std::vector<float> values,
                           Triangles corners = {}) {
  Attribute result;
  result.kind = kind;
  result.components = components;
  result.values = std::move(values);
  result.corners = std::move(corners);
  return result;
}

inline Attribute scalar(const std::string& name, std::vector<float> values) {
  Attribute result = attribute(Kind::scalar, 1, std::move(values));
  result.name = name;
  return result;
}

/// The same value, bit for bit, at every corner of every face, and at every vertex if it is there.
inline bool same_attribute(const Attribute& a, const Attribute& b, const IndexedMesh& mesh) {
  if (a.kind != b.kind || a.name != b.name || a.components != b.components || a.bytes != b.bytes ||
      a.downwards != b.downwards || a.per_vertex() != b.per_vertex())
    return false;
  const auto same = [&](std::size_t i, std::size_t k) {
    return std::memcmp(a.value(i), b.value(k), a.components * sizeof(float)) == 0;
  };
  if (a.per_vertex()) {
    if (a.values.size() != b.values.size()) return false;
    for (std::size_t i = 0; i < a.n_values(); ++i)
      if (!same(i, i)) return false;
  }
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
    for (std::size_t k = 0; k < 3; ++k)
      if (!same(a.at(mesh, face, k), b.at(mesh, face, k))) return false;
  return true;
}

/// The attribute of this kind, and of this name if it is a scalar; it must be there.
inline const Attribute& find(const Attributes& attributes, Kind kind, const std::string& name = "") {
  for (const Attribute& one : attributes)
    if (one.kind == kind && one.name == name) return one;
  throw FileError("the attribute is not there");
}

/// Two triangles of a square, 0 1 2 and 0 2 3.
inline IndexedMesh square() {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Attributes of the square, each value another one, that 32 bits hold and that text does not shorten.
inline Attribute square_normals() {
  return attribute(Kind::normal, 3, {0, 0, 1, 0, 0.6F, 0.8F, 1, 0, 0, -0.36F, 0.48F, 0.8F});
}
inline Attribute square_colours(bool bytes, bool opacity) {
  Attribute colour = attribute(Kind::colour, opacity ? 4 : 3, {});
  colour.bytes = bytes;
  for (std::size_t i = 0; i < 4 * colour.components; ++i)
    colour.values.push_back(bytes ? static_cast<float>(17 * i) / 255.0F : static_cast<float>(2 + i) / 20.0F);
  return colour;
}
inline Attribute square_texture() {
  return attribute(Kind::texture, 2, {0, 0.1F, 1, 0.25F, 1, 0.7F, 0.3F, 1});
}
/// With a seam along the diagonal: its two vertices have other values on either side.
inline Attribute square_seam() {
  return attribute(Kind::texture, 2, {0, 0.1F, 1, 0.25F, 1, 0.7F, 0.5F, 0, 0.5F, 1, 0.3F, 1},
                   {{0, 1, 2}, {3, 4, 5}});
}

/// A way to write a mesh, for tests that go through all of them.
struct Flavour {
  std::string file;
  WriteOptions options;
  std::string format;
};

inline std::vector<Flavour> flavours() {
  return {{"m.obj", {false, false}, "OBJ"},
          {"f.obj", {false, true}, "OBJ"},
          {"m.off", {false, false}, "OFF"},
          {"f.off", {false, true}, "OFF"},
          {"m.ply", {false, false}, "PLY, binary little endian"},
          {"f.ply", {false, true}, "PLY, binary little endian"},
          {"t.ply", {true, false}, "PLY, ASCII"},
          {"u.ply", {true, true}, "PLY, ASCII"},
          {"m.stl", {false, true}, "STL, binary"},
          {"t.stl", {true, true}, "STL, ASCII"},
          {"m.om", {false, false}, "OM"},
          {"f.om", {false, true}, "OM"},
          {"f.glb", {false, true}, "glTF, binary"}};
}

}  // namespace whittle::files
