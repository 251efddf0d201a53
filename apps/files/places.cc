#include "files/places.hh"

#include <cmath>

#include "files/IndexTable.hh"
#include "whittle/surface/UnionFind.hh"

namespace whittle::files {
namespace {

using Point = IndexedMesh::Point;

Hash hash_of(const Point& point) {
  // Comparing as numbers makes -0.0 equal to 0.0; the hash must agree, and x + 0.0 turns -0.0 into 0.0.
  return Hash().add(point.x() + 0.0).add(point.y() + 0.0).add(point.z() + 0.0);
}

/// Points in cubes as wide as the distance: what is within it of a point is in the 27 cubes around it.
class Grid {
 public:
  Grid(const std::vector<Point>& points, double width)
      : points_(points), width_(width), next_(points.size(), kEnd) {}

  void add(std::uint32_t i) {
    const Point cube = cube_of(points_[i]);
    const auto fresh = static_cast<std::uint32_t>(cubes_.size());
    const std::uint32_t cell =
        cells_.find_or_add(hash_of(cube), fresh, [&](std::uint32_t other) { return cubes_[other] == cube; });
    if (cell == fresh) {
      cubes_.push_back(cube);
      last_.push_back(kEnd);
    }
    next_[i] = last_[cell];
    last_[cell] = i;
  }

  /// Calls with each point of a cube.
  template <typename Call>
  void for_each_in(const Point& cube, Call call) const {
    const std::uint32_t cell = cells_.find(hash_of(cube), [&](std::uint32_t i) { return cubes_[i] == cube; });
    if (cell == IndexTable::none) return;
    for (std::uint32_t i = last_[cell]; i != kEnd; i = next_[i]) call(i);
  }

  Point cube_of(const Point& point) const { return (point / width_).array().floor(); }

 private:
  static constexpr std::uint32_t kEnd = static_cast<std::uint32_t>(-1);

  const std::vector<Point>& points_;
  double width_;
  IndexTable cells_;
  std::vector<Point> cubes_;
  std::vector<std::uint32_t> last_, next_;  // the points of each cube, the last one first
};

}  // namespace

std::vector<std::uint32_t> equal_places(const std::vector<Point>& points) {
  IndexTable table;
  table.reserve(points.size());
  std::vector<std::uint32_t> place(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    place[i] = points[i].allFinite()
                   ? table.find_or_add(hash_of(points[i]), i,
                                       [&](std::uint32_t other) { return points[other] == points[i]; })
                   : i;
  return place;
}

std::vector<std::uint32_t> near_places(const std::vector<Point>& points, double distance) {
  std::vector<std::uint32_t> place = equal_places(points);
  Grid grid(points, distance);
  detail::UnionFind places(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    if (place[i] != i) {
      places.join(i, place[i]);
      continue;
    }
    const Point cube = grid.cube_of(points[i]);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          grid.for_each_in(cube + Point(x, y, z), [&](std::uint32_t other) {
            if ((points[other] - points[i]).squaredNorm() <= distance * distance) places.join(i, other);
          });
    grid.add(i);
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) place[i] = places.root(i);
  return place;
}

}  // namespace whittle::files
