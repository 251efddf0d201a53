/// \file
/// Faces that a decimation has turned over.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::recipe {

/// Faces turned by more than 90 degrees, each against itself in the input.
/// \param origin  for each face after the one that it was
inline std::size_t count_flips(const IndexedMesh& before, const IndexedMesh& after,
                               const std::vector<std::uint32_t>& origin) {
  const auto normal = [](const IndexedMesh& mesh, std::size_t f) {
    const auto& t = mesh.triangles[f];
    const Eigen::Vector3d a = mesh.points[t[0]];
    return Eigen::Vector3d((mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a));
  };
  std::size_t flips = 0;
  for (std::size_t f = 0; f < origin.size(); ++f)
    flips += normal(before, origin[f]).dot(normal(after, f)) < 0;
  return flips;
}

}  // namespace whittle::recipe
