/// \file
/// A mesh renumbered for locality of memory.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::mq {

/// Vertices along a Morton curve, faces by the first of their vertices. Input meshes come in any order; an
/// algorithm that visits edges by cost has fewer cache misses when a one-ring lies together in memory.
struct MortonOrder {
  /// A bounding box no larger than this counts as a point: its reciprocal comes near the largest double.
  static constexpr double kLeastExtent = 1e-300;

  std::vector<std::uint32_t> vertex;                    ///< new index to old
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< in new indices
  std::vector<std::uint32_t> face;                      ///< new index to old; empty unless asked for
  Eigen::Vector3d low, high;                            ///< the bounding box; zero for an empty mesh

  template <typename Real>
  explicit MortonOrder(const IndexedMeshT<Real>& mesh, bool with_faces = false);

 private:
  /// Spreads ten bits to every third place.
  static std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
  }
};

template <typename Real>
MortonOrder::MortonOrder(const IndexedMeshT<Real>& mesh, bool with_faces)
    : low(Eigen::Vector3d::Zero()), high(Eigen::Vector3d::Zero()) {
  const std::size_t n = mesh.points.size();
  if (n == 0) return;
  Eigen::Matrix<Real, 3, 1> least = mesh.points[0], most = least;
  for (const auto& p : mesh.points) {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  low = least.template cast<double>();
  high = most.template cast<double>();
  const double extent = (high - low).maxCoeff();
  const double cells = extent > kLeastExtent ? 1023 / extent : 0;

  // A radix sort, ten bits at a time, of keys with the code above the vertex.
  std::vector<std::uint64_t> keys(n), sorted(n);
  for (std::size_t v = 0; v < n; ++v) {
    std::uint32_t code = 0;
    for (int i = 0; i < 3; ++i)
      code |= spread(static_cast<std::uint32_t>((static_cast<double>(mesh.points[v][i]) - low[i]) * cells))
              << i;
    keys[v] = std::uint64_t{code} << 32 | v;
  }
  for (int shift = 32; shift < 62; shift += 10) {
    std::array<std::uint32_t, 1025> start{};
    for (const std::uint64_t key : keys) ++start[(key >> shift & 1023) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const std::uint64_t key : keys) sorted[start[key >> shift & 1023]++] = key;
    keys.swap(sorted);
  }
  std::vector<std::uint32_t> place(n);  // old index to new
  vertex.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    vertex[i] = static_cast<std::uint32_t>(keys[i]);
    place[vertex[i]] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> start(n + 1, 0);
  const auto smallest = [&](const auto& t) { return std::min({place[t[0]], place[t[1]], place[t[2]]}); };
  for (const auto& t : mesh.triangles) ++start[smallest(t) + 1];
  for (std::size_t v = 1; v <= n; ++v) start[v] += start[v - 1];
  triangles.resize(mesh.triangles.size());
  if (with_faces) face.resize(mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    const std::uint32_t at = start[smallest(t)]++;
    triangles[at] = {place[t[0]], place[t[1]], place[t[2]]};
    if (with_faces) face[at] = static_cast<std::uint32_t>(f);
  }
}

}  // namespace whittle::mq
