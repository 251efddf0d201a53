/// \file
/// A bound on the distance between the input and the surface.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "whittle/mq/BoxTree.hh"
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
  static constexpr std::uint32_t kEnd = 0xffffffffu;
  static constexpr std::size_t kMany = 64;  // triangles; around more, boxes are worth building
  /// A face of a vertex's ring.
  struct Place {
    std::uint32_t vertex = kEnd;
    std::size_t face = 0;
  };

  bool assign(Change& change) const;
  bool lies_near(const Change& change) const;
  bool is_near_ring(const Vec& sample, std::uint32_t v, float least, Place& hint) const;

  std::vector<Vec> points_;
  detail::Rings rings_;
  std::vector<float> distances_;
  std::vector<std::uint32_t> next_, head_;  // linked lists: next of each point, head of each face
};

inline bool Bound::allows(Change& change) const {
  return assign(change) && lies_near(change);
}

/// Gives each point to the nearest triangle.
inline bool Bound::assign(Change& change) const {
  change.moves.clear();
  const std::vector<Triangle>& triangles = change.triangles;
  const auto square = [&](std::uint32_t point, const Triangle& t) {
    return detail::squared_distance(points_[point], t.a, t.b, t.c);
  };
  std::optional<BoxTree> tree;
  if (triangles.size() > kMany)
    tree.emplace(triangles.size(), [&](std::size_t i, BoxTree::Box& box) {
      for (const Vec& corner : {triangles[i].a, triangles[i].b, triangles[i].c}) box.add(corner);
    });
  const auto nearest = [&](std::uint32_t point) -> BoxTree::Found {
    if (tree)
      return tree->nearest(points_[point], [&](std::size_t i) { return square(point, triangles[i]); });
    BoxTree::Found best{triangles.size(), std::numeric_limits<float>::infinity()};
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const float here = square(point, triangles[i]);
      if (here < best.square) best = {i, here};
    }
    return best;
  };
  for (const std::uint32_t face : change.faces)
    for (std::uint32_t point = head_[face]; point != kEnd; point = next_[point]) {
      const BoxTree::Found found = nearest(point);
      if (!(found.square <= distances_[point] * distances_[point])) return false;
      change.moves.emplace_back(point, found.item < triangles.size() ? triangles[found.item].face : face);
    }
  return true;
}

/// Whether samples of the triangles are near the input.
inline bool Bound::lies_near(const Change& change) const {
  if (change.moves.empty() || change.triangles.empty()) return true;
  std::optional<BoxTree> tree;
  if (change.triangles.size() > kMany)
    tree.emplace(change.moves.size(),
                 [&](std::size_t i, BoxTree::Box& box) { box.add(points_[change.moves[i].first]); });
  Place hint;
  const auto is_near = [&](const Vec& sample) {
    const auto square = [&](std::size_t i) {
      return (points_[change.moves[i].first] - sample).squaredNorm();
    };
    BoxTree::Found best{0, std::numeric_limits<float>::infinity()};
    if (tree)
      best = tree->nearest(sample, square);
    else
      for (std::size_t i = 0; i < change.moves.size(); ++i)
        if (const float here = square(i); here < best.square) best = {i, here};
    return is_near_ring(sample, change.moves[best.item].first, best.square, hint);
  };
  for (const Triangle& t : change.triangles) {
    const Vec center = (t.a + t.b + t.c) / 3;
    const Vec samples[] = {center, (center + t.a) / 2, (center + t.b) / 2, (center + t.c) / 2,
                           (t.a + t.b) / 2};
    for (const Vec& sample : samples)
      if (!is_near(sample)) return false;
  }
  return is_near(change.triangles.front().a);
}

/// Whether a sample is near the input's faces around the nearest of the points.
/// \param least  the square of its distance from that point
/// \param hint   where the last face was found around a vertex with many of them, and now this one
inline bool Bound::is_near_ring(const Vec& sample, std::uint32_t v, float least, Place& hint) const {
  const float most = distances_[v] * distances_[v];
  const Ring ring = rings_[v];
  const std::size_t n = ring.n_faces(), start = n > kMany && hint.vertex == v ? hint.face : 0;
  std::size_t i = start;
  for (std::size_t k = 0; k < n && least > most; ++k) {
    i = start + k < n ? start + k : start + k - n;
    least =
        std::min(least, detail::squared_distance(sample, points_[v], points_[ring[i]], points_[ring[i + 1]]));
  }
  if (n > kMany) hint = {v, i};
  return least <= most;
}

}  // namespace whittle::mq
