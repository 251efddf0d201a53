/// \file
/// Which vertices have become one, and where they lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/surface/Surface.hh"

namespace whittle::detail {

/// The vertices of a surface in clusters. At first each is a cluster by itself.
template <typename Real>
class ClustersT {
 public:
  using Point = typename IndexedMeshT<Real>::Point;

  explicit ClustersT(const SurfaceT<Real>& surface) : surface_(surface) {
    nodes_.reserve(surface.n_vertices());
    for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
      const Point& p = surface.mesh().points[v];
      nodes_.push_back({v, v, 0, p});
    }
  }

  const SurfaceT<Real>& surface() const { return surface_; }
  std::size_t size() const { return nodes_.size(); }

  /// What has become of a vertex; the vertex itself if it still stands.
  std::uint32_t survivor(std::uint32_t v) const { return nodes_[v].survivor; }
  Eigen::Vector3d position(std::uint32_t survivor) const {
    return nodes_[survivor].position.template cast<double>();
  }
  void move(std::uint32_t survivor, const Point& position) { nodes_[survivor].position = position; }

  /// A note at a vertex, for whoever uses the clusters at the moment.
  std::uint32_t& mark(std::uint32_t v) { return nodes_[v].mark; }
  std::uint32_t mark(std::uint32_t v) const { return nodes_[v].mark; }
  /// A number that no mark has.
  std::uint32_t new_stamp() {
    if (stamp_ == 0xffffffffu) {
      for (Node& node : nodes_) node.mark = 0;
      stamp_ = 0;
    }
    return ++stamp_;
  }

  /// The next vertex of the same cluster; they go around in a circle.
  std::uint32_t next(std::uint32_t v) const { return nodes_[v].next; }

  /// Calls `visit(v)` for the vertices that have become `survivor`, itself included.
  template <typename Visit>
  void for_each_member(std::uint32_t survivor, Visit visit) const {
    std::uint32_t v = survivor;
    do visit(v);
    while ((v = nodes_[v].next) != survivor);
  }

  /// Moves the cluster of `from` over to `to`. Exchanging the links of one vertex of each list joins them,
  /// and exchanging them again parts them.
  void join(std::uint32_t from, std::uint32_t to) {
    relabel(from, to);
    std::swap(nodes_[from].next, nodes_[to].next);
  }
  void part(std::uint32_t from, std::uint32_t to) {
    std::swap(nodes_[from].next, nodes_[to].next);
    relabel(from, from);
  }

 private:
  /// All that is asked of a vertex at once, so that a visit costs one cache line.
  struct Node {
    std::uint32_t survivor, next;  ///< what it has become; the next of its cluster, which is a circular list
    std::uint32_t mark;
    Point position;  ///< of a survivor, rounded as the mesh will hold it
  };

  void relabel(std::uint32_t member, std::uint32_t survivor) {
    std::uint32_t v = member;
    do nodes_[v].survivor = survivor;
    while ((v = nodes_[v].next) != member);
  }

  const SurfaceT<Real>& surface_;
  std::vector<Node> nodes_;
  std::uint32_t stamp_ = 0;
};

}  // namespace whittle::detail
