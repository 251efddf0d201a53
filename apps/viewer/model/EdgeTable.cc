#include "model/EdgeTable.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <thread>

#include "whittle/surface/Surface.hh"

namespace whittle::viewer {
namespace {

/// An edge as one of its faces has it.
struct Side {
  std::array<std::uint32_t, 2> ends;  // the lower first
  std::uint32_t face;
  bool ascending;  // the face goes from the lower to the higher
};

std::vector<Side> sorted_sides(const IndexedMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      sides.push_back({{std::min(from, to), std::max(from, to)}, f, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.face < b.face;
  });
  return sides;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / 3.14159265358979323846;
}

}  // namespace

std::vector<Edge> edge_table(const IndexedMesh& mesh) {
  const SurfaceT<double> surface(mesh, {}, std::thread::hardware_concurrency());
  const std::vector<Side> sides = sorted_sides(mesh);
  std::vector<Edge> edges;
  edges.reserve(sides.size() / 2);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    const Side& first = sides[begin];
    while (end < sides.size() && sides[end].ends == first.ends) ++end;
    Edge edge;
    edge.ends = first.ends;
    edge.length = static_cast<float>((mesh.points[edge.ends[0]] - mesh.points[edge.ends[1]]).norm());
    if (end - begin == 1)
      edge.kind = EdgeKind::boundary;
    else if (end - begin > 2 || first.ascending == sides[begin + 1].ascending)
      edge.kind = EdgeKind::nonmanifold;
    else
      edge.angle = static_cast<float>(
          angle_between(surface.normal(first.face), surface.normal(sides[begin + 1].face)));
    edge.held = !surface.is_free(edge.ends[0]) && !surface.is_free(edge.ends[1]);
    edges.push_back(edge);
  }
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
