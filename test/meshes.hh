/// \file
/// Small named meshes for tests, built by hand or by formula.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "whittle/plan/CollapsePlan.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace meshes {

using whittle::IndexedMesh;
using Point = IndexedMesh::Point;
constexpr double kPi = 3.14159265358979323846;

/// A cone of `n` faces: the tip 0 at height `h` over a regular polygon of radius 1, whose corners are 1..n.
inline IndexedMesh cone(int n, double h) {
  IndexedMesh mesh;
  mesh.points.emplace_back(0, 0, h);
  for (int i = 0; i < n; ++i)
    mesh.points.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i)
    mesh.triangles.push_back({0, i + 1, (i + 1) % static_cast<std::uint32_t>(n) + 1});
  return mesh;
}

/// An inner triangle 0 1 2 inside a hexagon 3..8 of radius `r` in the plane; only the inner vertices are
/// free.
///
/// The triangle points down left, down right and up; its corner i sees the hexagon's corners 2i, 2i + 1 and
/// 2i + 2, which lie at 150 degrees and every 60 on.
inline IndexedMesh triangle_in_hexagon(const Point& a, const Point& b, const Point& c, double r) {
  IndexedMesh mesh;
  mesh.points = {a, b, c};
  for (int i = 0; i < 6; ++i)
    mesh.points.emplace_back(r * std::cos(kPi / 6 * (5 + 2 * i)), r * std::sin(kPi / 6 * (5 + 2 * i)), 0);
  mesh.triangles.push_back({0, 1, 2});
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t h0 = 3 + 2 * i, h1 = h0 + 1, h2 = 3 + (2 * i + 2) % 6, next = (i + 1) % 3;
    mesh.triangles.push_back({i, h0, h1});
    mesh.triangles.push_back({i, h1, h2});
    mesh.triangles.push_back({i, h2, next});
  }
  return mesh;
}

/// An open grid of `n` by `n` vertices, spacing 1, diagonals from (i, j) to (i + 1, j + 1); z from `height(i,
/// j)`.
template <typename Height>
IndexedMesh grid(std::uint32_t n, Height height) {
  IndexedMesh mesh;
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) mesh.points.emplace_back(i, j, height(i, j));
  for (std::uint32_t j = 0; j + 1 < n; ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t v = j * n + i;
      mesh.triangles.push_back({v, v + 1, v + n + 1});
      mesh.triangles.push_back({v, v + n + 1, v + n});
    }
  return mesh;
}
inline IndexedMesh flat_grid(std::uint32_t n) {
  return grid(n, [](std::uint32_t, std::uint32_t) { return 0.0; });
}

/// A strip of two rows of `n` vertices, spacing 1, `width` apart: 0 to n - 1 below, the others above.
inline IndexedMesh strip(std::uint32_t n, double width) {
  IndexedMesh mesh;
  for (int j = 0; j < 2; ++j)
    for (std::uint32_t i = 0; i < n; ++i) mesh.points.emplace_back(i, j * width, 0);
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    mesh.triangles.push_back({i, i + 1, n + i + 1});
    mesh.triangles.push_back({i, n + i + 1, n + i});
  }
  return mesh;
}

/// Three unit squares around the corner 0 of a cube; 1, 2 and 3 lie on its edges, `near` away from it. Free
/// are these four. Turning x to y to z maps the mesh onto itself.
inline IndexedMesh cube_corner(double near) {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {near, 0, 0}, {0, near, 0}, {0, 0, near}, {1, 0, 0},
                 {0, 1, 0}, {0, 0, 1},    {1, 1, 0},    {0, 1, 1},    {1, 0, 1}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t j = (i + 1) % 3, a = 1 + i, b = 1 + j, far = 7 + i;
    mesh.triangles.push_back({far, 4 + i, a});
    mesh.triangles.push_back({far, a, 0});
    mesh.triangles.push_back({far, 0, b});
    mesh.triangles.push_back({far, b, 4 + j});
  }
  return mesh;
}

inline IndexedMesh lone_triangle() {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// `n` points in one place and no faces.
inline IndexedMesh isolated_points(std::size_t n) {
  IndexedMesh mesh;
  mesh.points.assign(n, Point(1, 2, 3));
  return mesh;
}

inline IndexedMesh tetrahedron() {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

inline IndexedMesh octahedron() {
  IndexedMesh mesh;
  mesh.points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    mesh.triangles.push_back({i, (i + 1) % 4, 4});
    mesh.triangles.push_back({(i + 1) % 4, i, 5});
  }
  return mesh;
}

/// A closed torus of n by m vertices, outer radius 1, with smooth bumps; Euler characteristic 0.
inline IndexedMesh torus(std::uint32_t n, std::uint32_t m) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 2 * kPi * i / n, v = 2 * kPi * j / m,
                   r = 0.3 + 0.02 * std::sin(5 * u) * std::cos(3 * v);
      mesh.points.emplace_back((0.7 + r * std::cos(v)) * std::cos(u), (0.7 + r * std::cos(v)) * std::sin(u),
                               r * std::sin(v));
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % n) * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// A mesh times a factor, and moved.
inline IndexedMesh placed(IndexedMesh mesh, double scale, const Point& at) {
  for (Point& p : mesh.points) p = scale * p + at;
  return mesh;
}

/// Several meshes as one, one after the other.
inline IndexedMesh together(const std::vector<IndexedMesh>& parts) {
  IndexedMesh mesh;
  for (const IndexedMesh& part : parts) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (const auto& t : part.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh;
}

/// A torus with `n` octahedra far from each other around it, a hundredth of its size: 8 faces each.
inline IndexedMesh dusty_torus(std::size_t n) {
  std::vector<IndexedMesh> parts = {torus(48, 28)};
  for (std::size_t i = 0; i < n; ++i)
    parts.push_back(placed(octahedron(), 0.01, {2.0 + 0.1 * static_cast<double>(i), 0, 2}));
  return together(parts);
}

/// The mesh with every coordinate moved by up to `amount`, the same way for the same seed.
inline IndexedMesh shaken(IndexedMesh mesh, double amount, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return amount * (2 * static_cast<double>(random()) / 4294967295.0 - 1); };
  for (Point& p : mesh.points) p += Point{next(), next(), next()};  // braces keep the order of the calls
  return mesh;
}

/// The mesh without about one face in `one_in`: holes, and vertices that touch several of them.
inline IndexedMesh riddled(IndexedMesh mesh, unsigned one_in, unsigned seed) {
  std::mt19937 random(seed);
  auto& faces = mesh.triangles;
  faces.erase(std::remove_if(faces.begin(), faces.end(), [&](const auto&) { return random() % one_in == 0; }),
              faces.end());
  return mesh;
}

/// Edges of three or more faces, or of two that disagree about the direction.
inline std::size_t nonmanifold_edges(const IndexedMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  std::size_t twice = 0;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) twice += !seen.emplace(t[i], t[(i + 1) % 3]).second;
  return twice;
}

/// The collapses of a plan in order: what vanishes, and into what.
using Merges = std::vector<std::array<std::uint32_t, 2>>;
inline Merges merges(const whittle::CollapsePlan& plan) {
  Merges out;
  for (const whittle::Collapse& c : plan.collapses) out.push_back({c.from, c.to});
  return out;
}

/// Triangles as points, each rotated to begin with its least corner, sorted: equal for equal surfaces.
using Corners = std::array<std::array<double, 3>, 3>;
template <typename Real>
std::vector<Corners> canonical(const whittle::IndexedMeshT<Real>& mesh) {
  std::vector<Corners> out;
  for (const auto& t : mesh.triangles) {
    Corners corners;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) corners[i][k] = static_cast<double>(mesh.points[t[i]][k]);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    out.push_back(corners);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace meshes
