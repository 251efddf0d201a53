/// \file
/// Cutting a polygon into triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "files/PlanePoints.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

/// Cuts polygons of any number of corners into triangles without new vertices: a convex one into the fan of its first
/// corner, any other one by ear clipping (Meisters 1975; Held 2001 on what floating-point numbers ask for) in the plane
/// of Newell's normal. A polygon may touch itself, as where a bridge leads to a hole. It may be used again and again,
/// and keeps its memory.
class PolygonCutter {
 public:
  enum class Shape {
    convex,    ///< every corner turns left: a fan
    concave,   ///< cut by ear clipping; a corner on a straight line counts too
    crossing,  ///< two sides cross; cut as far as it can be
    flat       ///< no area: a fan
  };

  /// \param corners  at least three places in order, finite
  Shape cut(const std::vector<IndexedMesh::Point>& corners);

  /// Of the polygon that was cut last: two less than it has corners, which they name by their place in the order.
  /// Together they have each side of the polygon once, in its direction.
  const std::vector<IndexedMesh::Triangle>& triangles() const { return triangles_; }

 private:
  enum class Strictness { clear, touching, convex, any };

  void fan(std::uint32_t first);
  bool project(const std::vector<IndexedMesh::Point>& corners, bool& has_area);
  bool is_convex() const;
  bool crosses_itself();
  void clip_ears(bool crosses);
  void look_at_all();
  bool is_ear(std::uint32_t corner, Strictness strictness);
  bool is_blocked(std::uint32_t corner, Strictness strictness);
  bool blocks(std::uint32_t other, std::uint32_t corner, Strictness strictness) const;
  void clip(std::uint32_t corner);
  double turn(std::uint32_t corner) const { return area(prev_[corner], corner, next_[corner]); }
  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;  ///< twice; positive: to the left
  bool same_place(std::uint32_t a, std::uint32_t b) const;
  bool is_between(std::uint32_t other, std::uint32_t tip, std::uint32_t from, std::uint32_t to) const;

  std::vector<PlanePoint> at_;  ///< in the plane, of a size of 1
  std::vector<std::uint32_t> prev_, next_;
  std::vector<std::uint8_t> has_gone_;
  std::vector<std::uint32_t> some_;
  PointTree reflex_;    ///< corners that do not turn left
  NumberRing unknown_;  ///< corners that may be ears
  std::vector<IndexedMesh::Triangle> triangles_;
  std::size_t looks_ = 0;  ///< in all polygons so far
};

}  // namespace whittle::files
