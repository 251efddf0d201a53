/// \file
/// A triangle mesh as flat arrays: points, and triples of point indices.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace whittle {

/// Points and triangles in flat arrays.
///
/// Triangles are counter-clockwise seen from outside and hold indices into `points`. Any triangle soup is
/// allowed; planners leave alone what they cannot use, such as degenerate or non-manifold places.
/// \tparam Real  float or double, the precision of the coordinates.
template <typename Real>
struct IndexedMeshT {
  using Scalar = Real;
  using Point = Eigen::Matrix<Real, 3, 1>;
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

using IndexedMesh = IndexedMeshT<double>;

}  // namespace whittle
