#include "measure/Surface.hh"

#include <algorithm>
#include <cmath>

#include "whittle/surface/errors.hh"

namespace whittle::measure {

Surface::Surface(const IndexedMesh& mesh, Part part) : mesh_(mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& triangle = mesh.triangles[i];
    for (const std::uint32_t vertex : triangle) {
      if (!mesh.points[vertex].allFinite()) throw InvalidMesh("a coordinate is not finite");
    }
    const Corners face = corners(mesh, triangle);
    if (part == Part::with_area && face.degenerate()) continue;
    faces_.push_back(static_cast<std::uint32_t>(i));
    area_up_to_.push_back(area += face.area());
    for (const std::uint32_t vertex : triangle) used[vertex] = true;
  }
  if (faces_.empty())
    throw InvalidMesh(part == Part::all ? "the mesh has no face" : "the mesh has no face of positive area");
  for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
    if (used[vertex]) vertices_.push_back(static_cast<std::uint32_t>(vertex));
  }
}

std::size_t Surface::sampled_face(std::size_t i, std::size_t count) const {
  const double area = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * area_up_to_.back();
  const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end() - 1, area);
  return static_cast<std::size_t>(found - area_up_to_.begin());
}

Eigen::Vector3d Surface::sample(std::size_t i, std::size_t count) const {
  const Corners f = face(sampled_face(i, count));

  // R2: multiples of 1/g and 1/g^2 modulo 1, with g^3 = g + 1.
  constexpr double kFirst = 0.75487766624669276, kSecond = 0.56984029099805327;
  double whole;
  double u = std::modf(0.5 + kFirst * static_cast<double>(i), &whole);
  double v = std::modf(0.5 + kSecond * static_cast<double>(i), &whole);
  if (u + v > 1) {  // the other half of the parallelogram
    u = 1 - u;
    v = 1 - v;
  }
  return f.a + u * (f.b - f.a) + v * (f.c - f.a);
}

}  // namespace whittle::measure
