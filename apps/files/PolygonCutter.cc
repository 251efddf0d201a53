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

/// Pairs of corners that are looked at for one mesh: some seconds. Without a limit, a file of some megabytes that is one
/// spiral would take days.
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
  clip_ears();
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
  return (at_[b].x - at_[a].x) * (at_[c].y - at_[a].y) - (at_[b].y - at_[a].y) * (at_[c].x - at_[a].x);
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

/// Whether two sides have a point in common that is inside of both.
bool PolygonCutter::crosses_itself() {
  std::vector<std::uint32_t> sides(at_.size());
  std::iota(sides.begin(), sides.end(), 0U);
  const auto low = [&](std::uint32_t i) { return std::min(at_[i].x, at_[next_[i]].x); };
  const auto high = [&](std::uint32_t i) { return std::max(at_[i].x, at_[next_[i]].x); };
  std::sort(sides.begin(), sides.end(),
            [&](std::uint32_t i, std::uint32_t k) { return low(i) != low(k) ? low(i) < low(k) : i < k; });
  const auto apart = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const double left = area(a, b, c), right = area(a, b, d);
    return !((left > no_area && right < -no_area) || (left < -no_area && right > no_area));
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::uint32_t a = sides[i], b = next_[a];
    for (std::size_t k = i + 1; k < sides.size() && low(sides[k]) <= high(a); ++k) {
      if (++looks_ > most_looks) return true;
      const std::uint32_t c = sides[k], d = next_[c];
      if (!apart(a, b, c, d) && !apart(c, d, a, b)) return true;
    }
  }
  return false;
}

/// Round and round the ring, with a step over each second corner, so that not all triangles hang on one. When nothing is
/// an ear any more, less is asked of one.
void PolygonCutter::clip_ears() {
  const auto n = static_cast<std::uint32_t>(at_.size());
  is_reflex_.assign(n, 0);
  reflex_.clear();
  for (std::uint32_t i = 0; i < n; ++i) {
    if (turn(i) > 0) continue;
    is_reflex_[i] = 1;
    reflex_.push_back(i);
  }
  std::sort(reflex_.begin(), reflex_.end(), [&](std::uint32_t i, std::uint32_t k) {
    return at_[i].x != at_[k].x ? at_[i].x < at_[k].x : i < k;
  });

  Strictness strictness = Strictness::clear;
  std::uint32_t corner = 0, left = n, misses = 0;
  while (left > 3) {
    if (looks_ > most_looks) return fan(corner);
    if (is_ear(corner, strictness)) {
      const std::uint32_t next = next_[corner];
      clip(corner);
      --left;
      misses = 0;
      strictness = Strictness::clear;
      corner = next_[next];
      continue;
    }
    corner = next_[corner];
    if (++misses < left) continue;
    misses = 0;
    strictness = static_cast<Strictness>(static_cast<int>(strictness) + 1);
  }
  fan(corner);
}

bool PolygonCutter::is_ear(std::uint32_t corner, Strictness strictness) {
  if (strictness == Strictness::any) return true;
  if (!(turn(corner) > 0)) return false;
  return strictness == Strictness::convex || !is_blocked(corner, strictness);
}

/// Of a polygon that does not cross itself, one of the corners within an ear does not turn left.
bool PolygonCutter::is_blocked(std::uint32_t corner, Strictness strictness) {
  const double x[] = {at_[prev_[corner]].x, at_[corner].x, at_[next_[corner]].x};
  const auto [low, high] = std::minmax_element(x, x + 3);
  auto at = std::lower_bound(reflex_.begin(), reflex_.end(), *low,
                             [&](std::uint32_t i, double value) { return at_[i].x < value; });
  for (; at != reflex_.end() && at_[*at].x <= *high; ++at) {
    ++looks_;
    if (is_reflex_[*at] && blocks(*at, corner, strictness)) return true;
  }
  return false;
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
  is_reflex_[corner] = 0;
  // What turned left still does, but for rounding; what did not may by now.
  for (const std::uint32_t i : {before, after})
    if (is_reflex_[i] && turn(i) > 0) is_reflex_[i] = 0;
}

}  // namespace whittle::files
