#include "files/rounding.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "files/Choice.hh"
#include "text/number.hh"

namespace whittle::files {
namespace {

using Point = IndexedMesh::Point;

Eigen::AlignedBox3d box_of(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Point& point : mesh.points) box.extend(point);
  return box;
}

/// The number that a float's text says: the shortest, or one of so many digits.
double said_by_text(float value, int digits) {
  char text[32];
  const auto written =
      digits == 0 ? std::to_chars(text, text + sizeof(text), value)
                  : std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits);
  double said = 0;
  std::from_chars(text, written.ptr, said);
  return said;
}

}  // namespace

bool are_texts_of_floats(const IndexedMesh& mesh) {
  double largest = 0;
  for (const Point& point : mesh.points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
  const double last_bits = 1e-14 * largest;
  if (!(largest < 1e30)) return false;
  for (const Point& point : mesh.points)
    for (const double value : point) {
      const auto narrow = static_cast<float>(value);
      if (std::abs(said_by_text(narrow, 0) - value) > last_bits &&
          std::abs(said_by_text(narrow, 9) - value) > last_bits)
        return false;
    }
  return true;
}

double largest_rounding(const IndexedMesh& mesh, const Point& origin) {
  double largest = 0;
  for (const Point& point : mesh.points) {
    Point moved;
    for (int k = 0; k < 3; ++k) {
      const double value = point[k] - origin[k];
      // GCC 12 drops a conversion to float and back when it vectorizes.
      const volatile float narrow = static_cast<float>(value);
      moved[k] = static_cast<double>(narrow) - value;
    }
    largest = std::max(largest, moved.stableNorm());
  }
  return largest;
}

double tolerable_rounding(const IndexedMesh& mesh) {
  double shortest = HUGE_VAL;
  for (const IndexedMesh::Triangle& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (mesh.points[triangle[k]] - mesh.points[triangle[(k + 1) % 3]]).stableNorm();
      if (length > 0) shortest = std::min(shortest, length);
    }
  if (std::isfinite(shortest)) return shortest / 100;
  return mesh.points.empty() ? 0 : box_of(mesh).diagonal().stableNorm() / 1e6;
}

Point origin_for_floats(const IndexedMesh& mesh) {
  const double rounding = largest_rounding(mesh);
  if (rounding == 0 || rounding <= tolerable_rounding(mesh)) return Point::Zero();
  const Eigen::AlignedBox3d box = box_of(mesh);
  const double size = box.diagonal().maxCoeff();
  if (!(size > 0 && std::isfinite(size))) return Point::Zero();
  const double step = std::exp2(std::ceil(std::log2(size)));
  const Point origin = ((box.center() / step).array().round() * step).matrix();
  return 2 * largest_rounding(mesh, origin) < rounding ? origin : Point::Zero();
}

void note_rounding(const IndexedMesh& mesh, WriteReport& report, const Point& origin) {
  const double rounding = largest_rounding(mesh, origin);
  if (rounding == 0 || rounding <= tolerable_rounding(mesh)) return;
  reduce(report,
         "coordinates rounded to 32-bit floats, by up to " + text::significant(rounding, 3) + " units");
}

}  // namespace whittle::files
