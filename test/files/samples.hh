/// \file
/// A folder for the files of one test, and small meshes to put in it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "Folder.hh"
#include "files/MeshFile.hh"

namespace whittle::files {

using Triangles = std::vector<IndexedMesh::Triangle>;
using Names = std::vector<std::string>;

/// A folder to put files into and read them from.
class Folder : public scratch::Folder {
 public:
  /// Puts a file there and reads it as a mesh.
  MeshFile read(const std::string& name, const std::string& bytes) const {
    put(name, bytes);
    return read_mesh(*this / name);
  }

  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(*this / name, std::ios::binary) << bytes;
  }

  std::string get(const std::string& name) const { return scratch::contents(*this / name); }

  /// The message with which reading fails, from behind the folder's name: "a.obj:3: what".
  std::string error(const std::string& name, const std::string& bytes) const {
    put(name, bytes);
    return message([&] { read_mesh(*this / name); });
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
          {"t.stl", {true, true}, "STL, ASCII"}};
}

}  // namespace whittle::files
