#include "model/EdgeTable.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <thread>

#include "measure/sides.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/constants.hh"

namespace whittle::viewer {
namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / detail::kPi;
}

}  // namespace

std::vector<Edge> edge_table(const IndexedMesh& mesh) {
  const SurfaceT<double> surface(mesh, {}, std::thread::hardware_concurrency());
  const auto sides = measure::sides_by_edge(mesh.triangles, mesh.points.size(), measure::Faces::proper);
  std::vector<Edge> edges;
  edges.reserve(sides.size() / 2);
  for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    const measure::Side& first = *begin;
    Edge edge;
    edge.ends = {first.low, first.high};
    edge.length = static_cast<float>((mesh.points[first.low] - mesh.points[first.high]).norm());
    if (end - begin == 1)
      edge.kind = EdgeKind::boundary;
    else if (end - begin > 2 || rises(mesh.triangles, first) == rises(mesh.triangles, begin[1]))
      edge.kind = EdgeKind::nonmanifold;
    else
      edge.angle =
          static_cast<float>(angle_between(surface.normal(first.face()), surface.normal(begin[1].face())));
    edge.held = !surface.is_free(first.low) && !surface.is_free(first.high);
    edges.push_back(edge);
  });
  return edges;
}

const char* name(EdgeSet set) {
  switch (set) {
    case EdgeSet::boundary:
      return "boundary";
    case EdgeSet::nonmanifold:
      return "non-manifold";
    case EdgeSet::feature:
      return "feature";
    default:
      return "locked";
  }
}

EdgeSets::EdgeSets(const std::vector<Edge>& edges) {
  const auto ends = [&](EdgeSet set) -> auto& {
    return ends_[static_cast<std::size_t>(set)];
  };
  std::vector<const Edge*> plain;
  for (const Edge& edge : edges) {
    if (edge.kind == EdgeKind::boundary) {
      ends(EdgeSet::boundary).push_back(edge.ends);
    } else if (edge.kind == EdgeKind::nonmanifold) {
      ends(EdgeSet::nonmanifold).push_back(edge.ends);
    } else {
      plain.push_back(&edge);
      if (edge.held) ends(EdgeSet::locked).push_back(edge.ends);
    }
  }
  std::sort(plain.begin(), plain.end(),
            [](const Edge* a, const Edge* b) { return a->angle != b->angle ? a->angle > b->angle : a < b; });
  ends(EdgeSet::feature).reserve(plain.size());
  angles_.reserve(plain.size());
  for (const Edge* edge : plain) {
    ends(EdgeSet::feature).push_back(edge->ends);
    angles_.push_back(edge->angle);
  }
}

std::size_t EdgeSets::count(EdgeSet set, double feature_angle) const {
  if (set != EdgeSet::feature) return of(set).size();
  const auto blunt = std::partition_point(angles_.begin(), angles_.end(),
                                          [&](float angle) { return double(angle) >= feature_angle; });
  return static_cast<std::size_t>(blunt - angles_.begin());
}

}  // namespace whittle::viewer
