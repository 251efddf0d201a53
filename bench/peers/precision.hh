/// \file
/// Meshes from double to single precision and back.
#pragma once

#include "peers/Simplifier.hh"

namespace whittle::peers {

template <typename To, typename From>
IndexedMeshT<To> converted(const IndexedMeshT<From>& from) {
  IndexedMeshT<To> to;
  to.points.reserve(from.points.size());
  for (const auto& p : from.points) to.points.push_back(p.template cast<To>());
  to.triangles = from.triangles;
  return to;
}

inline IndexedMesh in_double(const Arrays& mesh) {
  return converted<double>(mesh);
}

inline Arrays in_float(const IndexedMesh& mesh) {
  return converted<float>(mesh);
}

}  // namespace whittle::peers
