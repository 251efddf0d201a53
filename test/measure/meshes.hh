/// \file
/// Small meshes whose facts and distances are known.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

inline IndexedMesh single_triangle() {
  return {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
}

/// Corners at the origin and one unit along each axis; outside is outside.
inline IndexedMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// A flat square [x, x + 1] x [0, 1] at height z, facing up.
inline IndexedMesh square(double x, double z) {
  return {{{x, 0, z}, {x + 1, 0, z}, {x + 1, 1, z}, {x, 1, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// The unit square as four triangles around its centre, which is raised to a height.
inline IndexedMesh tent(double height) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, height}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

/// n x n unit squares in the plane z = 0, two triangles each.
inline IndexedMesh grid(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) mesh.points.emplace_back(x, y, 0);
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// A torus with radii 2 and 1, of n x m quads cut in two.
inline IndexedMesh torus(std::uint32_t n, std::uint32_t m) {
  constexpr double kTurn = 6.283185307179586;
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = kTurn * i / n, v = kTurn * j / m;
      mesh.points.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
      const std::uint32_t i1 = (i + 1) % n, j1 = (j + 1) % m;
      const std::uint32_t a = i * m + j, b = i1 * m + j, c = i1 * m + j1, d = i * m + j1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// Triangles anywhere in the unit box; every fifth is a needle.
inline IndexedMesh soup(unsigned seed, std::uint32_t faces) {
  std::mt19937 random(seed);
  const auto real = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto point = [&] {
    const double x = real(), y = real(), z = real();
    return Eigen::Vector3d(x, y, z);
  };
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < faces; ++i) {
    const Eigen::Vector3d a = point(), b = point(), c = point();
    const Eigen::Vector3d off = c - a;
    mesh.points.insert(mesh.points.end(), {a, b, i % 5 == 0 ? Eigen::Vector3d(a + 1e-5 * off) : c});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Adds the faces of another mesh, on points of their own.
inline void append(IndexedMesh& mesh, const IndexedMesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

inline IndexedMesh transformed(IndexedMesh mesh, double scale, const Eigen::Vector3d& move) {
  for (auto& point : mesh.points) point = scale * point + move;
  return mesh;
}

}  // namespace whittle::measure
