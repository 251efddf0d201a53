/// \file
/// How mq keeps the input's vertices near the surface.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "whittle/surface/Rings.hh"
#include "whittle/surface/triangle.hh"

namespace whittle {

/// The vertices of the input, each in the list of the face that it is nearest to. A collapse takes the lists
/// of the faces around it apart, and is refused if a point is too far from all the faces that it leaves
/// there, or one of some samples of these from the input.
///
/// Several threads may use it at once as long as no two touch the same face.
class MemorylessQuadricBound {
 public:
  using Vec = Eigen::Vector3f;
  struct Triangle {
    std::uint32_t face;
    Vec a, b, c;
  };
  /// What `sort` has found for the faces around a collapse.
  struct Sorting {
    std::vector<std::uint32_t> faces = {};                            ///< whose lists are taken apart
    std::vector<Triangle> triangles = {};                             ///< what some of them become
    std::vector<std::pair<std::uint32_t, std::uint32_t>> moves = {};  ///< point and face
    void clear() {
      faces.clear();
      triangles.clear();
      moves.clear();
    }
  };

  MemorylessQuadricBound() : rings_({}, 0, false, 1) {}  ///< no bound

  /// \param distances  how far each point may come to lie from the faces.
  MemorylessQuadricBound(std::vector<Vec> points, Rings rings, std::vector<float> distances,
                         std::size_t n_faces)
      : points_(std::move(points)),
        rings_(std::move(rings)),
        distances_(std::move(distances)),
        next_(points_.size(), kEnd),
        head_(n_faces, kEnd) {}

  bool empty() const { return points_.empty(); }

  void put(std::uint32_t point, std::uint32_t face) {
    next_[point] = head_[face];
    head_[face] = point;
  }

  /// Finds the nearest triangle for each point of the faces.
  /// \return false  one is too far from all of them, or one of them from the input.
  bool sort(Sorting& sorting) const;

  /// Carries out what `sort` has found.
  void apply(const Sorting& sorting) {
    for (const std::uint32_t face : sorting.faces) head_[face] = kEnd;
    for (const auto& [point, face] : sorting.moves) put(point, face);
  }

 private:
  bool is_near(const Vec& sample, const Sorting& sorting) const;

  static constexpr std::uint32_t kEnd = 0xffffffffu;

  std::vector<Vec> points_;
  Rings rings_;
  std::vector<float> distances_;
  std::vector<std::uint32_t> next_, head_;  // of each point; of each face
};

inline bool MemorylessQuadricBound::sort(Sorting& sorting) const {
  sorting.moves.clear();
  for (const std::uint32_t face : sorting.faces)
    for (std::uint32_t point = head_[face]; point != kEnd; point = next_[point]) {
      float least = std::numeric_limits<float>::infinity();
      std::uint32_t nearest = face;
      for (const Triangle& t : sorting.triangles) {
        const float square = squared_distance(points_[point], t.a, t.b, t.c);
        if (!(square < least)) continue;
        least = square;
        nearest = t.face;
      }
      if (!(least <= distances_[point] * distances_[point])) return false;
      sorting.moves.emplace_back(point, nearest);
    }
  for (const Triangle& t : sorting.triangles) {
    const Vec center = (t.a + t.b + t.c) / 3;
    const Vec samples[] = {center, (center + t.a) / 2, (center + t.b) / 2, (center + t.c) / 2,
                           (t.a + t.b) / 2};
    for (const Vec& sample : samples)
      if (!is_near(sample, sorting)) return false;
  }
  return sorting.triangles.empty() || is_near(sorting.triangles.front().a, sorting);
}

/// Whether one of the input's faces around the nearest of the points is near.
inline bool MemorylessQuadricBound::is_near(const Vec& sample, const Sorting& sorting) const {
  float least = std::numeric_limits<float>::infinity();
  std::uint32_t v = kEnd;
  for (const auto& [point, face] : sorting.moves) {
    const float square = (points_[point] - sample).squaredNorm();
    if (!(square < least)) continue;
    least = square;
    v = point;
  }
  if (v == kEnd) return true;
  const float most = distances_[v] * distances_[v];
  const Ring ring = rings_[v];
  for (std::size_t i = 0; i < ring.n_faces() && least > most; ++i)
    least = std::min(least, squared_distance(sample, points_[v], points_[ring[i]], points_[ring[i + 1]]));
  return least <= most;
}

}  // namespace whittle
