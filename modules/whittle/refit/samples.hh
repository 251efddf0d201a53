/// \file
/// Which point of a simplified mesh stands for which of the original.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "whittle/refit/Fitted.hh"

namespace whittle::refitting {

constexpr std::uint32_t kNoFace = 0xffffffffu;

/// A point of the original and the point of the simplified mesh that stands for it.
struct Sample {
  std::uint32_t face = kNoFace;  ///< of the simplified mesh
  std::array<float, 3> at{};     ///< barycentric, none negative
  float distance = 0;  ///< of the point from there along the original's normal; times the root of its weight
  Vec normal = Vec::Zero();  ///< the original's, times the root of its weight
};

/// Finds the face around a vertex that stands for a point of the original. The normals count as much as the place: where
/// the mesh is thin or folded, the nearest face may be one of the other side.
/// \param v       what the corner of the point's face has become
/// \param normal  of length 1
/// \param weight  the area that the point stands for
inline Sample attached(const Fitted& fitted, std::uint32_t v, const Vec& p, const Vec& normal, float weight) {
  constexpr float kAlike = 0.9f,  // the cosine above which the first face that holds the point is good enough
      kUnlike = 0.5f;             // and the one from which down none stands for it; it counts in full at 1
  float best = -std::numeric_limits<float>::infinity(), cosine = 0;
  std::array<float, 3> at{};
  Sample sample;
  const auto [begin, end] = fitted.corners.of(v);
  for (const std::uint32_t* c = begin; c != end; ++c) {
    const Face& face = fitted.faces[*c / 3];
    const float x = face.along[0].dot(p) + face.offset[0], y = face.along[1].dot(p) + face.offset[1];
    const float outside = std::min({x, y, 1 - x - y, 0.0f}), alike = face.normal.dot(normal),
                score = outside - (1 - alike);
    if (!(face.area > 0) || !(score > best)) continue;
    best = score;
    cosine = alike;
    at = {std::max(x, 0.0f), std::max(y, 0.0f), std::max(1 - x - y, 0.0f)};
    sample.face = *c / 3;
    if (outside == 0 && alike > kAlike) break;
  }
  if (!(cosine > kUnlike)) return {};
  weight *= (cosine - kUnlike) / (1 - kUnlike);
  const float sum = at[0] + at[1] + at[2], root = std::sqrt(weight);
  Vec there = Vec::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    sample.at[k] = at[k] / sum;
    there += sample.at[k] * fitted.points[fitted.triangles[sample.face][k]];
  }
  sample.normal = root * normal;
  sample.distance = sample.normal.dot(p - there);
  return sample;
}

/// The samples of all faces of the original that have an area: three each, halfway from the centroid to the corners.
/// \param points      of the original, in the frame.
/// \param triangles   of the original.
/// \param vertex_map  for each vertex of the original the one that it became, or one that is not there
inline std::vector<Sample> attach(const std::vector<Vec>& points, const std::vector<Triangle>& triangles,
                                  const std::vector<std::uint32_t>& vertex_map, const Fitted& fitted,
                                  detail::Crew& crew) {
  constexpr std::size_t kAtOnce = 4096;
  std::vector<Sample> samples(3 * triangles.size());
  crew.each_range(triangles.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Triangle& t = triangles[f];
      const std::array<Vec, 3> p{points[t[0]], points[t[1]], points[t[2]]};
      const Face face(p[0], p[1], p[2]);
      if (!(face.area > 0)) continue;
      const Vec centroid = (p[0] + p[1] + p[2]) / 3;
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::uint32_t v = vertex_map[t[k]]; v < fitted.points.size())
          samples[3 * f + k] = attached(fitted, v, (centroid + p[k]) / 2, face.normal, face.area / 3);
    }
  });
  return samples;
}

}  // namespace whittle::refitting
