/// \file
/// What holds of every mesh that a reader returns, whatever the file.
#pragma once

#include <cmath>
#include <string>

#include "files/MeshFile.hh"

namespace whittle::files {

/// What is wrong with it; null if it can be used as it is.
inline const char* unsound(const IndexedMesh& mesh, const attributes::Attribute& attribute) {
  if (attribute.components < 1 || attribute.components > 4) return "an absurd number of components";
  if (attribute.values.size() % attribute.components != 0) return "values that are not whole";
  if (attribute.per_vertex()) {
    if (attribute.n_values() != mesh.points.size()) return "not a value for each vertex";
  } else {
    if (attribute.corners.size() != mesh.triangles.size()) return "not corners for each triangle";
    for (const IndexedMesh::Triangle& corners : attribute.corners)
      for (const std::uint32_t corner : corners)
        if (corner >= attribute.n_values()) return "a corner's value is out of range";
  }
  if (attribute.kind == attributes::Kind::scalar) return nullptr;
  for (const float value : attribute.values)
    if (!std::isfinite(value)) return "a value is not finite";
  return nullptr;
}

inline const char* unsound(const MeshFile& file) {
  for (const IndexedMesh::Point& point : file.mesh.points)
    if (!point.allFinite()) return "a coordinate is not finite";
  for (const auto& [a, b, c] : file.mesh.triangles) {
    const std::size_t points = file.mesh.points.size();
    if (a >= points || b >= points || c >= points) return "an index is out of range";
    if (a == b || b == c || c == a) return "a triangle names a vertex twice";
  }
  for (const attributes::Attribute& attribute : file.attributes)
    if (const char* what = unsound(file.mesh, attribute)) return what;
  return nullptr;
}

}  // namespace whittle::files
