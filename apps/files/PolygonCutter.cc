#include "files/PolygonCutter.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace whittle::files {
namespace {

using Point = IndexedMesh::Point;

/// An area that rounding may have made, of a polygon of a size of 1.
constexpr double no_area = 1e-12;

/// How often corners are looked at for one mesh: some seconds. A polygon that crosses itself often may take more without
/// an end in sight; one that does not stays far below.
constexpr std::size_t most_looks = std::size_t{1} << 30;

/// The sum of the fan's normals, whichever corner it has; and the largest of them, for a polygon that has as much area
/// to the left as to the right.
struct Normals {
  Point newell = Point::Zero(), largest = Point::Zero();
};

Normals normals_of(const std::vector<Point>& corners, double scale) {
  Normals normals;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Point normal = ((corners[i - 1] - corners[0]) * scale).cross((corners[i] - corners[0]) * scale);
    normals.newell += normal;
    if (normal.squaredNorm() > normals.largest.squaredNorm()) normals.largest = normal;
  }
  return normals;
}

}  // namespace

PolygonCutter::Shape PolygonCutter::cut(const std::vector<Point>& corners) {
  triangles_.clear();
  const auto n = static_cast<std::uint32_t>(corners.size());
  prev_.resize(n);
  next_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    next_[i] = i + 1 == n ? 0 : i + 1;
    prev_[i] = i == 0 ? n - 1 : i - 1;
  }
  bool has_area = false;
  if (!project(corners, has_area)) {
    fan(0);
    return Shape::flat;
  }
  if (has_area && is_convex()) {
    fan(0);
    return Shape::convex;
  }
  const bool crosses = !has_area || crosses_itself();
  clip_ears(crosses);
  return crosses || looks_ > most_looks ? Shape::crossing : Shape::concave;
}

/// Of what is left of the ring.
void PolygonCutter::fan(std::uint32_t first) {
  for (std::uint32_t i = next_[first]; next_[i] != first; i = next_[i])
    triangles_.push_back({first, i, next_[i]});
}

/// \param has_area  more to the one side than to the other
/// \return false if there is no plane
bool PolygonCutter::project(const std::vector<Point>& corners, bool& has_area) {
  double size = 0;
  for (const Point& corner : corners) size = std::max(size, (corner - corners[0]).cwiseAbs().maxCoeff());
  if (!(size > 0 && std::isfinite(size) && std::isfinite(1 / size))) return false;
  const Normals normals = normals_of(corners, 1 / size);
  has_area = normals.newell.norm() > no_area;
  if (!has_area && normals.largest.norm() <= no_area) return false;

  const Point normal = (has_area ? normals.newell : normals.largest).normalized();
  // Exact for the planes of the axes: Duff et al. 2017, "Building an orthonormal basis, revisited".
  const double sign = std::copysign(1.0, normal.z());
  const double a = -1 / (sign + normal.z());
  const double b = normal.x() * normal.y() * a;
  const Point u(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x());
  const Point v(b, sign + normal.y() * normal.y() * a, -normal.y());
  at_.clear();
  for (const Point& corner : corners) {
    const Point from_first = (corner - corners[0]) / size;
    at_.push_back({u.dot(from_first), v.dot(from_first)});
  }
  return true;
}

double PolygonCutter::area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return doubled_area(at_[a], at_[b], at_[c]);
}

bool PolygonCutter::same_place(std::uint32_t a, std::uint32_t b) const {
  return at_[a].x == at_[b].x && at_[a].y == at_[b].y;
}

/// All corners turn left, and from the first one they are seen in order within half a turn; a pentagram's are not.
bool PolygonCutter::is_convex() const {
  for (std::uint32_t i = 0; i < at_.size(); ++i) {
    if (!(turn(i) > 0)) return false;
    if (i >= 2 && !(area(0, 1, i) > 0 && (next_[i] == 0 || area(0, i, next_[i]) > 0))) return false;
  }
  return true;
}

/// Whether two sides have a point in common that is inside of both. Few sides are compared as they overlap in x, which is
/// right whatever their rounding; many by a sweep.
bool PolygonCutter::crosses_itself() {
  constexpr std::size_t many = 1000;
  if (at_.size() > many) return any_sides_cross(at_);
  some_.resize(at_.size());
  std::iota(some_.begin(), some_.end(), 0U);
  const auto low = [&](std::uint32_t i) { return std::min(at_[i].x, at_[next_[i]].x); };
  const auto high = [&](std::uint32_t i) { return std::max(at_[i].x, at_[next_[i]].x); };
  std::sort(some_.begin(), some_.end(),
            [&](std::uint32_t i, std::uint32_t k) { return low(i) != low(k) ? low(i) < low(k) : i < k; });
  for (std::size_t i = 0; i < some_.size(); ++i) {
    const std::uint32_t a = some_[i], b = next_[a];
    for (std::size_t k = i + 1; k < some_.size() && low(some_[k]) <= high(a); ++k)
      if (sides_cross(at_[a], at_[b], at_[some_[k]], at_[next_[some_[k]]])) return true;
  }
  return false;
}

void PolygonCutter::look_at_all() {
  for (std::uint32_t i = 0; i < at_.size(); ++i)
    if (!has_gone_[i]) unknown_.insert(i);
}

/// Round and round the ring, with a step over each second corner, so that not all triangles hang on one. What is no ear
/// becomes one only when a neighbour goes, where no sides cross. When nothing is an ear any more, less is asked of one.
void PolygonCutter::clip_ears(bool crosses) {
  const auto n = static_cast<std::uint32_t>(at_.size());
  some_.clear();
  for (std::uint32_t i = 0; i < n; ++i)
    if (!(turn(i) > 0)) some_.push_back(i);
  reflex_.build(at_, some_);
  has_gone_.assign(n, 0);
  unknown_.clear(n);
  look_at_all();

  Strictness strictness = Strictness::clear;
  std::uint32_t corner = 0, begin = 0, left = n;
  bool is_all_known = false;  // all that are left have been looked at since the last one went
  while (left > 3) {
    if (++looks_ > most_looks) return fan(corner);
    const std::uint32_t found = unknown_.next(corner);
    if (found == NumberRing::none) {
      if (is_all_known || !crosses) strictness = static_cast<Strictness>(static_cast<int>(strictness) + 1);
      is_all_known = true;
      corner = begin;
      look_at_all();
      continue;
    }
    corner = found;
    unknown_.erase(corner);
    if (!is_ear(corner, strictness)) continue;
    const std::uint32_t before = prev_[corner], next = next_[corner];
    clip(corner);
    --left;
    is_all_known = false;
    strictness = Strictness::clear;
    unknown_.insert(before);
    unknown_.insert(next);
    corner = begin = next_[next];
  }
  fan(begin);
}

bool PolygonCutter::is_ear(std::uint32_t corner, Strictness strictness) {
  if (strictness == Strictness::any) return true;
  if (!(turn(corner) > 0)) return false;
  return strictness == Strictness::convex || !is_blocked(corner, strictness);
}

/// Of a polygon that does not cross itself, one of the corners within an ear does not turn left.
bool PolygonCutter::is_blocked(std::uint32_t corner, Strictness strictness) {
  return reflex_.any({at_[prev_[corner]], at_[corner], at_[next_[corner]]}, looks_,
                     [&](std::uint32_t other) { return blocks(other, corner, strictness); });
}

bool PolygonCutter::blocks(std::uint32_t other, std::uint32_t corner, Strictness strictness) const {
  const std::uint32_t a = prev_[corner], b = corner, c = next_[corner];
  if (other == a || other == b || other == c) return false;
  // One that lies on a corner of the ear is in the way if a side leads from there into the ear.
  if (same_place(other, a)) return is_between(other, a, b, c);
  if (same_place(other, b)) return is_between(other, b, c, a);
  if (same_place(other, c)) return is_between(other, c, a, b);
  const double least = std::min({area(a, b, other), area(b, c, other), area(c, a, other)});
  return strictness == Strictness::clear ? least >= 0 : least > 0;
}

/// Whether one of the sides at `other`, which is at the place of `tip`, leads between those to `from` and `to`.
bool PolygonCutter::is_between(std::uint32_t other, std::uint32_t tip, std::uint32_t from,
                               std::uint32_t to) const {
  const auto inside = [&](std::uint32_t end) { return area(tip, from, end) > 0 && area(tip, end, to) > 0; };
  return inside(prev_[other]) || inside(next_[other]);
}

void PolygonCutter::clip(std::uint32_t corner) {
  const std::uint32_t before = prev_[corner], after = next_[corner];
  triangles_.push_back({before, corner, after});
  next_[before] = after;
  prev_[after] = before;
  has_gone_[corner] = 1;
  reflex_.remove(corner);
  // What turned left still does, but for rounding; what did not may by now.
  for (const std::uint32_t i : {before, after})
    if (reflex_.has(i) && turn(i) > 0) reflex_.remove(i);
}

}  // namespace whittle::files
