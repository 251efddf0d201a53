/// \file
/// Which face of a simplified mesh stands for which of the original.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "whittle/mq/Four.hh"
#include "whittle/refit/Fitted.hh"

namespace whittle::refitting {

constexpr std::uint32_t kNoFace = 0xffffffffu;

/// The original, in the frame.
struct Original {
  template <typename Real>
  Original(const IndexedMeshT<Real>& mesh, const Frame<Real>& frame, detail::Crew& crew)
      : triangles(mesh.triangles), points(frame.local(mesh.points, crew)), normals(triangles.size()) {
    crew.each_range(triangles.size(), Fitted::kAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) normals[f] = normal(f);
    });
  }

  struct alignas(16) Normal {
    Vec direction;  ///< of length 1; 0 if the face has no area
    float area;
  };

  const std::vector<Triangle>& triangles;
  std::vector<Vec> points;      ///< and one more
  std::vector<Normal> normals;  ///< for each face

 private:
  Normal normal(std::size_t f) const {
    const auto& [a, b, c] = triangles[f];
    const Vec cross = (points[b] - points[a]).cross(points[c] - points[a]);
    const float square = cross.squaredNorm(), length = std::sqrt(square);
    if (!(square > 0) || !std::isfinite(1 / length)) return {Vec::Zero(), 0};
    return {cross / length, length / 2};
  }
};

/// Finds the face around a vertex that stands best for a point. The normals count as much as the place: where the mesh is
/// thin or folded, the nearest face may be one of the other side.
inline std::uint32_t best_around(const Fitted& fitted, std::uint32_t v, const Vec& p, const Vec& normal) {
  constexpr float kAlike = 0.9f;  // the cosine above which the first face that holds the point is good enough
  using mq::Four;
  float best = -std::numeric_limits<float>::infinity();
  std::uint32_t found = kNoFace;
  const auto [begin, end] = fitted.corners.of(v);
  for (const std::uint32_t* c = begin; c != end;) {
    const auto n = std::min<std::size_t>(4, static_cast<std::size_t>(end - c));
    std::array<const Face*, 4> faces;
    for (std::size_t i = 0; i < 4; ++i) faces[i] = &fitted.faces[c[std::min(i, n - 1)] / 3];
    const auto row = [&](const auto& member) {
      return mq::transposed({member(*faces[0]), member(*faces[1]), member(*faces[2]), member(*faces[3])});
    };
    const auto normals = row([](const Face&f) { return f.normal.data(); }),
               first = row([](const Face&f) { return f.along_0.data(); }),
               second = row([](const Face&f) { return f.along_1.data(); });
    const Four x = first[0] * p.x() + first[1] * p.y() + first[2] * p.z() + first[3],
               y = second[0] * p.x() + second[1] * p.y() + second[2] * p.z() + second[3],
               alike = normals[0] * normal.x() + normals[1] * normal.y() + normals[2] * normal.z(),
               outside = x.min(y).min(1 - x - y).min(0.0f), score = outside + alike;
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (!(normals[3][k] > 0) || !(score[k] > best)) continue;
      best = score[k];
      found = c[i] / 3;
    }
    if (best > kAlike) break;
    c += n;
  }
  return found;
}

/// For each face of the original the face of the simplified mesh that stands for its centroid; kNoFace if it has no area or
/// there is none. Those that are left stand for themselves.
/// \param vertex_map   for each vertex of the original the one that it became, or one that is not there
/// \param face_origin  for each face of the simplified mesh the one of the original that it was
inline std::vector<std::uint32_t> find_homes(const Original& original,
                                             const std::vector<std::uint32_t>& vertex_map,
                                             const std::vector<std::uint32_t>& face_origin,
                                             const Fitted& fitted, detail::Crew& crew) {
  std::vector<std::uint32_t> homes(original.triangles.size(), kNoFace);
  for (std::uint32_t f = 0; f < face_origin.size(); ++f) homes[face_origin[f]] = f;
  crew.each_range(homes.size(), Fitted::kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = original.triangles[f];
      const std::uint32_t v = vertex_map[a];
      if (homes[f] != kNoFace || v >= fitted.n_vertices() || !(original.normals[f].area > 0)) continue;
      const Vec centroid = (original.points[a] + original.points[b] + original.points[c]) / 3;
      homes[f] = best_around(fitted, v, centroid, original.normals[f].direction);
    }
  });
  return homes;
}

}  // namespace whittle::refitting
