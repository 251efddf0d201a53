/// \file
/// A simplified mesh whose vertices are about to move.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Lists.hh"
#include "whittle/surface/threads.hh"

namespace whittle::refitting {

using Vec = Eigen::Vector3f;
using Triangle = std::array<std::uint32_t, 3>;

/// The frame in which the original's bounding box has its centre at 0 and its largest side is 1, so that floats are enough.
template <typename Real>
struct Frame {
  using Point = typename IndexedMeshT<Real>::Point;

  explicit Frame(const std::vector<Point>& points) {
    Point low = points.front(), high = low;
    for (const Point& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    center = low / 2 + high / 2;
    const Real side = (high / 2 - low / 2).maxCoeff() * 2;
    if (side > 0) scale = side;
  }
  std::vector<Vec> local(const std::vector<Point>& points) const {
    std::vector<Vec> out;
    out.reserve(points.size());
    for (const Point& p : points) out.push_back(((p - center) / scale).template cast<float>());
    return out;
  }

  Point center;
  Real scale = 1;
};

/// A face of the simplified mesh.
struct Face {
  Vec normal = Vec::Zero();  ///< of length 1; 0 if the face has no area
  float area = 0;
  // Barycentric coordinates of corners 0 and 1 at p: along[i] p + offset[i].
  std::array<Vec, 2> along{Vec::Zero(), Vec::Zero()};
  std::array<float, 2> offset{};

  Face() = default;
  Face(const Vec& a, const Vec& b, const Vec& c) {
    const Vec cross = (b - a).cross(c - a);
    const float square = cross.squaredNorm(), length = std::sqrt(square);
    if (!(square > 0) || !std::isfinite(1 / square)) return;
    normal = cross / length;
    area = length / 2;
    along = {cross.cross(c - b) / square, cross.cross(a - c) / square};
    offset = {-along[0].dot(b), -along[1].dot(c)};
  }
};

/// What is known of the simplified mesh.
struct Fitted {
  /// \param stays  for each vertex whether it keeps its place; those on the boundary do in any case
  template <typename Real>
  Fitted(const IndexedMeshT<Real>& mesh, const Frame<Real>& frame, const std::vector<bool>& stays)
      : triangles(mesh.triangles),
        corners(detail::Lists::of_corners(mesh.triangles, mesh.points.size())),
        is_free(mesh.points.size()),
        points(frame.local(mesh.points)),
        faces(triangles.size()) {
    std::vector<std::uint32_t> next, previous;
    for (std::uint32_t v = 0; v < points.size(); ++v) is_free[v] = !stays[v] && is_inner(v, next, previous);
  }

  void set_faces(detail::Crew& crew) {
    constexpr std::size_t kAtOnce = 4096;
    crew.each_range(faces.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        const auto& [a, b, c] = triangles[f];
        faces[f] = Face(points[a], points[b], points[c]);
      }
    });
  }

  const std::vector<Triangle>& triangles;
  detail::Lists corners;      ///< of each vertex; corner k of face f is 3 f + k
  std::vector<char> is_free;  ///< whether a vertex may move
  std::vector<Vec> points;
  std::vector<Face> faces;

 private:
  /// Whether each edge at a vertex has two faces, which agree about its direction.
  /// \param next, previous  room for its neighbours
  bool is_inner(std::uint32_t v, std::vector<std::uint32_t>& next,
                std::vector<std::uint32_t>& previous) const {
    next.clear();
    previous.clear();
    const auto [begin, end] = corners.of(v);
    for (const std::uint32_t* c = begin; c != end; ++c) {
      next.push_back(triangles[*c / 3][(*c + 1) % 3]);
      previous.push_back(triangles[*c / 3][(*c + 2) % 3]);
    }
    std::sort(next.begin(), next.end());
    std::sort(previous.begin(), previous.end());
    return begin != end && next == previous && std::adjacent_find(next.begin(), next.end()) == next.end();
  }
};

}  // namespace whittle::refitting
