#include "fidelity/NormalDeviation.hh"

#include <algorithm>
#include <cmath>
#include <future>
#include <thread>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/triangle.hh"
#include "whittle/surface/constants.hh"

namespace whittle::bench {
namespace {

constexpr double kDegrees = 180 / detail::kPi;

unsigned threads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

/// Calls `work(i)` for all i below `count`, on all cores; calls must not touch one another's data.
template <typename Work>
void for_each_index(std::size_t count, Work work) {
  const std::size_t parts = threads();
  std::vector<std::future<void>> running;
  for (std::size_t part = 0; part < parts; ++part)
    running.push_back(std::async(std::launch::async, [=, &work] {
      for (std::size_t i = part * count / parts; i < (part + 1) * count / parts; ++i) work(i);
    }));
  for (auto& one : running) one.get();
}

}  // namespace

NormalDeviation normal_deviation(const IndexedMesh& original, const IndexedMesh& simplified) {
  const measure::Surface before(original), after(simplified);
  const measure::ClosestFace closest(before, threads());
  std::vector<double> sums(after.size()), largest(after.size());
  for_each_index(after.size(), [&](std::size_t i) {
    const measure::Corners face = after.face(i);
    const Eigen::Vector3d normal = face.normal().normalized(), centroid = (face.a + face.b + face.c) / 3;
    for (const Eigen::Vector3d& point :
         {centroid, Eigen::Vector3d((centroid + face.a) / 2), Eigen::Vector3d((centroid + face.b) / 2),
          Eigen::Vector3d((centroid + face.c) / 2)}) {
      const Eigen::Vector3d other = before.face(closest.closest(point).face).normal().normalized();
      // The arc tangent keeps its digits near 0 and 180 degrees, where the arc cosine loses them.
      const double angle = kDegrees * std::atan2(normal.cross(other).norm(), normal.dot(other));
      sums[i] += angle / 4;
      largest[i] = std::max(largest[i], angle);
    }
  });
  NormalDeviation result;
  double area = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double weight = after.face(i).area();
    area += weight;
    result.mean_degrees += weight * sums[i];
    result.max_degrees = std::max(result.max_degrees, largest[i]);
  }
  result.mean_degrees /= area;
  return result;
}

TriangleQuality triangle_quality(const IndexedMesh& mesh) {
  std::vector<double> values;
  values.reserve(mesh.triangles.size());
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const measure::Corners t = measure::corners(mesh, triangle);
    const double squares = (t.b - t.a).squaredNorm() + (t.c - t.b).squaredNorm() + (t.a - t.c).squaredNorm();
    values.push_back(squares > 0 ? 4 * std::sqrt(3.0) * t.area() / squares : 0);
    sum += values.back();
  }
  if (values.empty()) return {};
  const auto fifth = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 20);
  std::nth_element(values.begin(), fifth, values.end());
  return {sum / static_cast<double>(values.size()), *fifth};
}

std::vector<double> distances_to(const IndexedMesh& original, const IndexedMesh& simplified) {
  const measure::Surface surface(simplified);
  const measure::ClosestFace closest(surface, threads());
  std::vector<double> distances(original.points.size());
  for_each_index(distances.size(), [&](std::size_t i) {
    distances[i] = std::sqrt(closest.closest(original.points[i]).squared_distance);
  });
  return distances;
}

}  // namespace whittle::bench
