#include "measure/smooth_limit.hh"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/constants.hh"

namespace whittle::measure {

double smooth_limit(const IndexedMesh& mesh) {
  constexpr double kSaddle = 180.0 / 225;
  struct Vertex {
    double angles = 0, area = 0;
    std::int64_t turns = 0;  // of its edges: 0 in all where each has a face on both sides
  };
  std::vector<Vertex> vertices(mesh.points.size());
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d cross =
        (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
    const double twice = cross.norm();
    area += twice / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& here = mesh.points[t[k]];
      const Eigen::Vector3d next = mesh.points[t[(k + 1) % 3]] - here,
                            last = mesh.points[t[(k + 2) % 3]] - here;
      Vertex& vertex = vertices[t[k]];
      vertex.angles += std::atan2(twice, next.dot(last));
      vertex.area += twice / 6;
      vertex.turns += std::int64_t{t[(k + 1) % 3]} - std::int64_t{t[(k + 2) % 3]};
    }
  }
  if (!(area > 0)) return 0;
  // Of k^(1/3): on a vertex's share of the area k is its share of the curvature over that.
  double integral = 0;
  for (const Vertex& vertex : vertices) {
    if (!(vertex.area > 0) || vertex.turns != 0) continue;
    const double defect = 2 * detail::kPi - vertex.angles;
    integral += std::cbrt((defect > 0 ? defect : -kSaddle * defect) * vertex.area * vertex.area);
  }
  return std::pow(integral, 1.5) / std::sqrt(180 * area);
}

}  // namespace whittle::measure
