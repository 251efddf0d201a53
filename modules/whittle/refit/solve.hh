/// \file
/// The moves of the vertices that bring a simplified mesh closer to the original.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "whittle/mq/Four.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/refit/Fitted.hh"
#include "whittle/refit/homes.hh"
#include "whittle/surface/constants.hh"

namespace whittle::refitting {

/// What a vertex knows of the points around it, for u, its best move if its neighbours move alike: the first three rows,
/// a symmetric matrix, times u are the last row.
using Sum = Eigen::Matrix<float, 4, 3>;

/// Adds the squares of the distances of three points of a face of the original from its home, halfway from its centroid to
/// its corners, each along the original's normal.
/// \param sums  of all vertices
inline void add_points(const Original& original, std::size_t f, const Fitted& fitted, std::uint32_t home,
                       Sum* sums) {
  constexpr float kUnlike = 0.5f,  // the cosine from which down a home does not count; it counts in full at 1
      kSixth = 1.0f / 6, kShare = 1 / (3 * (1 - kUnlike));
  using mq::Four;
  const Face& face = fitted.faces[home];
  const auto& [normal, area] = original.normals[f];
  const float cosine = normal.dot(face.normal);
  if (!(cosine > kUnlike)) return;
  const auto& [a, b, c] = original.triangles[f];
  const auto& corners = fitted.triangles[home];
  const float* const p = original.points[a].data();
  const float* const q = fitted.points[corners[0]].data();
  const mq::FourVectors points = mq::gathered({p, original.points[b].data(), original.points[c].data(), p}),
                        corner_points = mq::gathered(
                            {q, fitted.points[corners[1]].data(), fitted.points[corners[2]].data(), q});
  const auto dot = [](const mq::FourVectors& v, const Vec& w) -> Four {
    return v.x() * w.x() + v.y() * w.y() + v.z() * w.z();
  };
  const auto halfway = [&](const Vec& along, float offset) -> Four {
    const Four at = dot(points, along);
    return at * 0.5f + ((at[0] + at[1] + at[2]) * kSixth + offset);
  };
  Four x = halfway(face.along_0, face.offset_0), y = halfway(face.along_1, face.offset_1);
  Four z = (1 - x - y).max(0.0f);
  x = x.max(0.0f);
  y = y.max(0.0f);
  const Four scale = 1 / (x + y + z), heights = dot(corner_points, normal);
  const std::array<Four, 3> at{x * scale, y * scale, z * scale};
  // n.p is the same for all points of the face.
  const Four distance = dot(points, normal)[0] - at[0] * heights[0] - at[1] * heights[1] - at[2] * heights[2];
  const Vec weighted = kShare * area * (cosine - kUnlike) * normal;
  for (std::size_t k = 0; k < 3; ++k) {
    const Four moment = at[k] * distance;
    const float share = at[k][0] + at[k][1] + at[k][2];
    const Eigen::Vector4f row(share * normal.x(), share * normal.y(), share * normal.z(),
                              moment[0] + moment[1] + moment[2]);
    sums[corners[k]] += row * weighted.transpose();
  }
}

/// The sums of all vertices. What the points leave open the faces' own planes hold, the more the fewer points there are.
inline std::vector<Sum> sums_of(const Original& original, const std::vector<std::uint32_t>& homes,
                                const Fitted& fitted, detail::Crew& crew) {
  constexpr float kHold = 0.4f;
  constexpr std::size_t kMostSlices = 16;
  const std::size_t n = fitted.n_vertices(), n_faces = homes.size();
  // Each slice of the original has sums of its own, and there are as many for any number of threads: so are the results.
  const std::size_t slices = std::clamp<std::size_t>(n_faces / n, 1, kMostSlices),
                    at_once = (n_faces + slices - 1) / slices;
  std::vector<Sum> sums(slices * n, Sum::Zero());
  crew.each(slices, [&](std::size_t slice) {
    for (std::size_t f = slice * at_once; f < std::min(n_faces, (slice + 1) * at_once); ++f)
      if (homes[f] != kNoFace) add_points(original, f, fitted, homes[f], &sums[slice * n]);
  });
  const float hold = kHold / 3 * static_cast<float>(fitted.faces.size()) / static_cast<float>(n_faces);
  crew.each_range(n, Fitted::kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Sum& sum = sums[v];
      for (std::size_t slice = 1; slice < slices; ++slice) sum += sums[slice * n + v];
      const auto [first, last] = fitted.corners.of(v);
      for (const std::uint32_t* c = first; c != last; ++c) {
        const Face& face = fitted.faces[*c / 3];
        sum += Eigen::Vector4f(face.normal.x(), face.normal.y(), face.normal.z(), 0) *
               (hold * face.area * face.normal).transpose();
      }
    }
  });
  sums.resize(n);
  return sums;
}

/// The factor of the moves in a round. Where neighbours do not move alike, moves are too short, by a factor that depends on
/// how different they are and mostly lies in 1.1..2.6; rounds with different factors, as those of Chebyshev's iteration,
/// leave the least error of all of them. The largest comes first.
inline float step(std::size_t round, std::size_t rounds) {
  constexpr double kCenter = 0.644, kHalfWidth = 0.268;  // of the reciprocals
  const double angle = detail::kPi * (2 * static_cast<double>(round) + 1) / (2 * static_cast<double>(rounds));
  return static_cast<float>(1 / (kCenter - kHalfWidth * std::cos(angle)));
}

/// The sum of the faces' areas around a vertex, each along its normal.
inline Vec area_around(const Fitted& fitted, std::uint32_t v) {
  Vec sum = Vec::Zero();
  const auto [begin, end] = fitted.corners.of(v);
  for (const std::uint32_t* c = begin; c != end; ++c) {
    const Face& face = fitted.faces[*c / 3];
    sum += face.area * face.normal;
  }
  return sum;
}

/// The move of a vertex with the least error, if its neighbours move alike. 0 if there is none.
inline Vec best_move(const Fitted& fitted, std::uint32_t v, const Sum& sum) {
  constexpr float kPull = 1e-3f;
  mq::SymmetricMatrix matrix{sum(0, 0), sum(1, 0), sum(2, 0), sum(1, 1), sum(2, 1), sum(2, 2)};
  const Vec side = sum.row(3).transpose();
  const float trace = matrix.trace();
  if (!(trace > 0)) return Vec::Zero();
  matrix += mq::SymmetricMatrix::identity(kPull * trace);
  if (fitted.freedom[v] == Freedom::along_normal) {
    const Vec normal = area_around(fitted, v);
    const float stiffness = normal.dot(matrix * normal);
    return stiffness > 0 ? Vec(normal.dot(side) / stiffness * normal) : Vec(Vec::Zero());
  }
  Vec pivots;
  const Vec move = matrix.solve(side, pivots);
  return pivots.minCoeff() > 0 ? move : Vec(Vec::Zero());
}

/// Where a vertex goes: its best move times a factor, at most a fifth of its shortest edge. What is less than a hundred
/// thousandth of that is rounding.
inline Vec moved(const Fitted& fitted, std::uint32_t v, const Sum& sum, float factor) {
  constexpr float kFarthest = 0.2f, kLeast = 1e-5f;
  const Vec& here = fitted.points[v];
  const Vec move = factor * best_move(fitted, v, sum);
  float shortest = std::numeric_limits<float>::infinity();
  const auto [begin, end] = fitted.corners.of(v);
  for (const std::uint32_t* c = begin; c != end; ++c)
    shortest =
        std::min(shortest, (fitted.points[fitted.triangles[*c / 3][(*c + 1) % 3]] - here).squaredNorm());
  const float length = move.norm(), edge = std::sqrt(shortest), farthest = kFarthest * edge;
  if (!move.allFinite() || !(length > kLeast * edge)) return here;
  return here + (length > farthest ? Vec(move * (farthest / length)) : move);
}

/// Whether a face would turn by more than about 45 degrees, or over against the original, with its corners there.
/// \param upright  its normal in the original, of length 1
inline bool turns_too_far(const Face& before, const Vec& upright, const Vec& a, const Vec& b, const Vec& c) {
  constexpr float kLeastCosine = 0.7f;
  const Vec normal = (b - a).cross(c - a);
  const float length = normal.norm(), cosine = upright.dot(normal);
  if (before.area > 0 && !(before.normal.dot(normal) > kLeastCosine * length)) return true;
  return !(cosine > 0) && !(cosine >= upright.dot(before.normal) * length);
}

/// Moves the vertices; the corners of a face that would turn too far stay.
/// \return how many stay for that
inline std::size_t move_all(Fitted& fitted, const std::vector<Sum>& sums, float factor,
                            const Original& original, const std::vector<std::uint32_t>& face_origin,
                            detail::Crew& crew) {
  std::vector<Vec> there(fitted.points);
  crew.each_range(fitted.n_vertices(), Fitted::kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (fitted.freedom[v] != Freedom::none)
        there[v] = moved(fitted, static_cast<std::uint32_t>(v), sums[v], factor);
  });
  std::vector<char> turns(fitted.faces.size());
  const auto turns_now = [&](std::size_t f) {
    const auto& [a, b, c] = fitted.triangles[f];
    return turns_too_far(fitted.faces[f], original.normals[face_origin[f]].direction, there[a], there[b],
                         there[c]);
  };
  crew.each_range(turns.size(), Fitted::kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) turns[f] = turns_now(f);
  });
  std::size_t refused = 0;
  std::vector<std::uint32_t> open;  // faces that may turn too far
  for (std::uint32_t f = 0; f < turns.size(); ++f)
    if (turns[f]) open.push_back(f);
  while (!open.empty()) {
    const std::uint32_t f = open.back();
    open.pop_back();
    if (!turns_now(f)) continue;
    for (const std::uint32_t v : fitted.triangles[f]) {
      if (there[v] == fitted.points[v]) continue;
      there[v] = fitted.points[v];
      ++refused;
      const auto [begin, end] = fitted.corners.of(v);
      for (const std::uint32_t* c = begin; c != end; ++c) open.push_back(*c / 3);
    }
  }
  fitted.points = std::move(there);
  return refused;
}

}  // namespace whittle::refitting
