#include "files/gaps.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "files/places.hh"
#include "measure/sides.hh"

namespace whittle::files {

Gaps find_gaps(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const IndexedMesh::Point& point : mesh.points) box.extend(point);
  std::vector<bool> on_boundary(mesh.points.size(), false);
  double sum = 0;
  std::size_t edges = 0;
  const auto sides = measure::sides_by_edge(mesh.triangles, mesh.points.size());
  measure::for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    if (end - begin != 1) return;
    on_boundary[begin->low] = on_boundary[begin->high] = true;
    sum += (mesh.points[begin->low] - mesh.points[begin->high]).norm();
    ++edges;
  });
  Gaps gaps;
  if (edges == 0) return gaps;

  constexpr double part_of_edge = 0.1, part_of_diagonal = 0.01;  // the latter is what a weld may be
  gaps.length =
      std::min(part_of_edge * sum / static_cast<double>(edges), part_of_diagonal * box.diagonal().norm());
  std::vector<IndexedMesh::Point> points;
  for (std::size_t v = 0; v < on_boundary.size(); ++v)
    if (on_boundary[v]) points.push_back(mesh.points[v]);
  gaps.boundary_vertices = points.size();
  if (!(gaps.length > 0)) return gaps;
  const std::vector<std::uint32_t> first = near_places(points, gaps.length);
  std::vector<std::size_t> here(points.size(), 0);
  for (const std::uint32_t place : first) ++here[place];
  for (const std::uint32_t place : first) gaps.near += here[place] > 1 ? 1 : 0;
  return gaps;
}

}  // namespace whittle::files
