/// \file
/// A bound on the distance between the input and the surface.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "whittle/mq/Vertex.hh"
#include "whittle/surface/Rings.hh"
#include "whittle/surface/triangle.hh"

namespace whittle::mq {

/// Each vertex of the input is in the list of the face that it is nearest to. A collapse redistributes the
/// lists of the faces around it, and is refused if a point is too far from all the faces that remain there,
/// or a sample of one of those is too far from the input.
///
/// Several threads may use it at once as long as no two touch the same face.
class Bound {
 public:
  struct Triangle {
    std::uint32_t face;
    Vec a, b, c;
  };
  /// The faces around a collapse before and after, and where the points go.
  struct Change {
    std::vector<std::uint32_t> faces = {};                            ///< before: whose lists are emptied
    std::vector<Triangle> triangles = {};                             ///< after: what some of them become
    std::vector<std::pair<std::uint32_t, std::uint32_t>> moves = {};  ///< point and face; set by `allows`
    void clear() {
      faces.clear();
      triangles.clear();
      moves.clear();
    }
  };

  /// \param rings      of the points in the input.
  /// \param distances  the largest distance from the faces, for each point.
  Bound(std::vector<Vec> points, detail::Rings rings, std::vector<float> distances, std::size_t n_faces)
      : points_(std::move(points)),
        rings_(std::move(rings)),
        distances_(std::move(distances)),
        next_(points_.size(), kEnd),
        head_(n_faces, kEnd) {}

  void put(std::uint32_t point, std::uint32_t face) {
    next_[point] = head_[face];
    head_[face] = point;
  }

  /// Finds the nearest triangle for each point of the faces.
  /// \return false  a point is too far from all triangles, or a triangle from the input.
  bool allows(Change& change) const;

  /// Carries out a change that `allows` has completed.
  void apply(const Change& change) {
    for (const std::uint32_t face : change.faces) head_[face] = kEnd;
    for (const auto& [point, face] : change.moves) put(point, face);
  }

 private:
  bool is_near(const Vec& sample, const Change& change) const;

  static constexpr std::uint32_t kEnd = 0xffffffffu;

  std::vector<Vec> points_;
  detail::Rings rings_;
  std::vector<float> distances_;
  std::vector<std::uint32_t> next_, head_;  // linked lists: next of each point, head of each face
};

inline bool Bound::allows(Change& change) const {
  change.moves.clear();
  for (const std::uint32_t face : change.faces)
    for (std::uint32_t point = head_[face]; point != kEnd; point = next_[point]) {
      float least = std::numeric_limits<float>::infinity();
      std::uint32_t nearest = face;
      for (const Triangle& t : change.triangles) {
        const float square = detail::squared_distance(points_[point], t.a, t.b, t.c);
        if (!(square < least)) continue;
        least = square;
        nearest = t.face;
      }
      if (!(least <= distances_[point] * distances_[point])) return false;
      change.moves.emplace_back(point, nearest);
    }
  for (const Triangle& t : change.triangles) {
    const Vec center = (t.a + t.b + t.c) / 3;
    const Vec samples[] = {center, (center + t.a) / 2, (center + t.b) / 2, (center + t.c) / 2,
                           (t.a + t.b) / 2};
    for (const Vec& sample : samples)
      if (!is_near(sample, change)) return false;
  }
  return change.triangles.empty() || is_near(change.triangles.front().a, change);
}

/// Whether a sample is near the input's faces around the nearest of the points.
inline bool Bound::is_near(const Vec& sample, const Change& change) const {
  float least = std::numeric_limits<float>::infinity();
  std::uint32_t v = kEnd;
  for (const auto& [point, face] : change.moves) {
    const float square = (points_[point] - sample).squaredNorm();
    if (!(square < least)) continue;
    least = square;
    v = point;
  }
  if (v == kEnd) return true;
  const float most = distances_[v] * distances_[v];
  const Ring ring = rings_[v];
  for (std::size_t i = 0; i < ring.n_faces() && least > most; ++i)
    least =
        std::min(least, detail::squared_distance(sample, points_[v], points_[ring[i]], points_[ring[i + 1]]));
  return least <= most;
}

}  // namespace whittle::mq
