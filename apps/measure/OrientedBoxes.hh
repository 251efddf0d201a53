/// \file
/// Finds faces near a point where boxes along the axes tell little: long or flat faces at all angles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "measure/Surface.hh"

namespace whittle::measure {

/// A tree of boxes that are turned to fit what they hold (Gottschalk, Lin and Manocha 1996). Many faces around one
/// vertex or edge have boxes along the axes that nearly all overlap; turned ones lie beside one another. The surface
/// must outlive it.
class OrientedBoxes {
 public:
  /// \param faces  of the surface; at least one
  /// \param go_on  as ClosestFace's
  /// \throw Cancelled  go_on returned false.
  OrientedBoxes(const Surface& surface, std::vector<std::uint32_t> faces, const std::function<bool()>& go_on);

  /// How many of the faces' boxes along the axes hold a point of the box around all of them on average.
  static double mean_overlap(const Surface& surface, const std::vector<std::uint32_t>& faces);

  /// Calls `visit(face)` with every face that may lie within `distance`, nearer boxes first; it returns the distance to
  /// go on with, at most the last one.
  template <typename Visit>
  void search(const Eigen::Vector3d& point, double distance, Visit visit) const {
    search(0, point, distance, visit);
  }

 private:
  static constexpr std::size_t kLeaf = 4;  // faces
  static constexpr double kRounding = 1e-9;

  struct Node {
    Eigen::Matrix3d axes;  ///< in its rows
    Eigen::Vector3d centre, half;
    std::uint32_t begin, end;  ///< of `faces_`
    std::uint32_t second;      ///< its second child; the first one follows it. 0: it is a leaf

    /// A little less than the square of the distance.
    double square(const Eigen::Vector3d& p) const {
      const Eigen::Vector3d away = (axes * (p - centre)).cwiseAbs() - half;
      return (1 - kRounding) * away.cwiseMax(0).squaredNorm();
    }
  };

  void build(std::uint32_t begin, std::uint32_t end, const std::function<bool()>& go_on);
  Node fitted(std::uint32_t begin, std::uint32_t end) const;
  void split(std::uint32_t begin, std::uint32_t middle, std::uint32_t end);

  template <typename Visit>
  void search(std::uint32_t at, const Eigen::Vector3d& point, double& distance, Visit& visit) const {
    const Node& node = nodes_[at];
    if (node.second == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) distance = visit(faces_[i]);
      return;
    }
    std::array<std::pair<double, std::uint32_t>, 2> child{
        std::pair(nodes_[at + 1].square(point), at + 1),
        std::pair(nodes_[node.second].square(point), node.second)};
    if (child[1].first < child[0].first) std::swap(child[0], child[1]);
    for (const auto& [square, next] : child)
      if (square <= distance * distance) search(next, point, distance, visit);
  }

  const Surface& surface_;
  std::vector<std::uint32_t> faces_;
  double size_ = 0;  // the largest coordinate
  std::vector<Node> nodes_;
};

}  // namespace whittle::measure
