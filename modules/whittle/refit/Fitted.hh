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
  /// With one point more at the end, so that each has another float after it, as `mq::gathered` wants.
  std::vector<Vec> local(const std::vector<Point>& points, detail::Crew& crew) const {
    constexpr std::size_t kAtOnce = 16384;
    std::vector<Vec> out(points.size() + 1);
    crew.each_range(points.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        out[v] = ((points[v] - center) / scale).template cast<float>();
    });
    return out;
  }

  Point center;
  Real scale = 1;
};

/// A face of the simplified mesh, as three rows of four floats.
struct alignas(16) Face {
  Vec normal = Vec::Zero();  ///< of length 1; 0 if the face has no area
  float area = 0;
  // Barycentric coordinates of corners 0 and 1 at p: along p + offset.
  Vec along_0 = Vec::Zero();
  float offset_0 = 0;
  Vec along_1 = Vec::Zero();
  float offset_1 = 0;

  Face() = default;
  Face(const Vec& a, const Vec& b, const Vec& c) {
    const Vec cross = (b - a).cross(c - a);
    const float square = cross.squaredNorm(), length = std::sqrt(square);
    if (!(square > 0) || !std::isfinite(1 / square)) return;
    normal = cross / length;
    area = length / 2;
    along_0 = cross.cross(c - b) / square;
    along_1 = cross.cross(a - c) / square;
    offset_0 = -along_0.dot(b);
    offset_1 = -along_1.dot(c);
  }
};

/// How a vertex may move.
enum class Freedom : std::uint8_t { none, along_normal, any };

/// What is known of the simplified mesh.
struct Fitted {
  static constexpr std::size_t kAtOnce = 4096;  // faces or vertices that a thread takes

  /// \param asked  for each vertex how it may move; those on the boundary may not in any case
  template <typename Real>
  Fitted(const IndexedMeshT<Real>& mesh, const Frame<Real>& frame, const std::vector<Freedom>& asked,
         detail::Crew& crew)
      : triangles(mesh.triangles),
        corners(detail::Lists::of_corners(mesh.triangles, mesh.points.size())),
        freedom(mesh.points.size()),
        points(frame.local(mesh.points, crew)),
        faces(triangles.size()) {
    const std::size_t n = n_vertices();
    crew.each_range(n, (n + crew.size() - 1) / crew.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> marks(n, kNoMark);
      for (std::size_t v = begin; v < end; ++v)
        freedom[v] = asked[v] != Freedom::none && is_inner(static_cast<std::uint32_t>(v), marks)
                         ? asked[v]
                         : Freedom::none;
    });
  }

  std::size_t n_vertices() const { return freedom.size(); }

  void set_faces(detail::Crew& crew) {
    crew.each_range(faces.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        const auto& [a, b, c] = triangles[f];
        faces[f] = Face(points[a], points[b], points[c]);
      }
    });
  }

  const std::vector<Triangle>& triangles;
  detail::Lists corners;  ///< of each vertex; corner k of face f is 3 f + k
  std::vector<Freedom> freedom;
  std::vector<Vec> points;  ///< and one more
  std::vector<Face> faces;

 private:
  static constexpr std::uint32_t kNoMark = 0xffffffffu;

  /// Whether each edge at a vertex has two faces, which agree about its direction.
  /// \param marks  for each vertex 2 w if it comes next in a face around w, the last vertex asked about; 2 w + 1 if it comes
  ///               before w in another one, too
  bool is_inner(std::uint32_t v, std::vector<std::uint32_t>& marks) const {
    const auto [begin, end] = corners.of(v);
    for (const std::uint32_t* c = begin; c != end; ++c) {
      std::uint32_t& mark = marks[triangles[*c / 3][(*c + 1) % 3]];
      if (mark == 2 * v) return false;
      mark = 2 * v;
    }
    for (const std::uint32_t* c = begin; c != end; ++c) {
      std::uint32_t& mark = marks[triangles[*c / 3][(*c + 2) % 3]];
      if (mark != 2 * v) return false;
      mark = 2 * v + 1;
    }
    return begin != end;
  }
};

}  // namespace whittle::refitting
