/// \file
/// Finds the face of a surface that is closest to a point.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "measure/OrientedBoxes.hh"
#include "measure/Surface.hh"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace whittle::measure {

/// A search tree over the faces of a surface, which must outlive it. Safe to ask from several threads.
///
/// Embree's tree works in single precision; it only rules faces out, with a margin wider than its rounding.
/// Distances are computed in double precision on the original coordinates, so the answer is that of a search
/// over all faces. Where the faces' boxes along the axes overlap so much that it rules out little, as where thousands
/// of faces meet in a vertex or an edge, OrientedBoxes takes its place.
class ClosestFace {
 public:
  /// \param threads  that build the tree; 0: all cores.
  /// \param go_on    called periodically by any thread that builds; false ends it. It must not throw.
  /// \throw Cancelled  go_on returned false.
  ClosestFace(const Surface& surface, unsigned threads, const std::function<bool()>& go_on = {});
  ClosestFace(Surface&& surface, unsigned threads, const std::function<bool()>& go_on = {}) = delete;

  struct Answer {
    double squared_distance;
    std::size_t face;  ///< an index into the surface; of equally close faces the first
  };
  Answer closest(const Eigen::Vector3d& point) const;
  /// The same, and faster, if the distance from a face is known already.
  Answer closest(const Eigen::Vector3d& point, const Answer& known) const;

  /// All faces within a distance of a point, in ascending order.
  std::vector<std::size_t> within(const Eigen::Vector3d& point, double distance) const;
  /// The same, but of faces that coincide, corner for corner the same way around, only the first.
  std::vector<std::size_t> distinct_within(const Eigen::Vector3d& point, double distance) const;

 private:
  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };

  void find_distinct();
  void build_tree(unsigned threads, const std::function<bool()>& go_on);

  template <typename Visit>
  void search(const Eigen::Vector3d& point, double distance, Visit visit) const;

  const Surface& surface_;
  std::vector<std::uint32_t> faces_;  // in the tree: the first of those that coincide, ascending
  std::vector<std::uint32_t>
      next_;  // of each face the next one that coincides with it, itself if there is none
  Eigen::Vector3d centre_;
  double scale_ = 1;  // Embree's coordinates are (point - centre_) * scale_, within [-0.5, 0.5]
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
  std::optional<OrientedBoxes> oriented_;  // in place of the scene
};

}  // namespace whittle::measure
