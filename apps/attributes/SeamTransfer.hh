/// \file
/// Texture coordinates through a decimation in which vertices move along seams.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "attributes/Attribute.hh"
#include "attributes/Sampler.hh"
#include "attributes/transfer.hh"
#include "whittle/plan/Patches.hh"
#include "whittle/surface/Lists.hh"

namespace whittle::attributes {

/// Carries one attribute of corners over so that nothing tears.
///
/// A vertex inside a chart gets the value at the nearest point of the chart's faces around its members, the vertices
/// that became it. On a seam each patch around it gets the value at a point of its border, and the two of a seam the
/// same one: the nearest on the edges between the two at the members. Where three charts or more meet and the corner
/// has moved along the seam of two of them, the others keep the value at the corner.
class SeamTransfer {
 public:
  SeamTransfer(const Attribute& in, const Decimation& d);
  Attribute run();

 private:
  /// A place where patches met.
  struct Spot {
    double squared_distance;
    std::vector<std::uint32_t> groups;  ///< of patches, that meet there; ascending
    std::uint32_t seam;                 ///< of `patches_`, where the place is on one; else kNone
    std::uint32_t vertex;               ///< the place, where it is one
    double share;                       ///< on a seam, from its lower vertex to its higher one
  };
  static constexpr std::uint32_t kNone = 0xffffffffu;

  void carry(std::uint32_t w);
  void keep(std::uint32_t v, detail::Lists::Range corners);
  void find_groups(detail::Lists::Range corners);
  std::vector<Spot> spots(const Eigen::Vector3d& p, detail::Lists::Range members);
  void add_value(std::uint32_t group, const Spot& spot);
  void place_groups(const Eigen::Vector3d& p, detail::Lists::Range members);
  /// The group of the patch of the i-th face of `patches_`; none if nothing is left of it.
  std::optional<std::uint32_t> group_of(std::uint32_t i);

  const Attribute& in_;
  const Decimation& d_;
  Sampler sampler_;
  detail::Lists members_, corners_;
  detail::Patches patches_;
  std::vector<IndexedMesh::Triangle> wedges_, out_;
  // At the current vertex:
  std::map<std::uint32_t, std::uint32_t> known_;  // kept values, or groups by wedge
  std::map<std::uint32_t, std::uint32_t> group_;  // by patch
  std::vector<std::uint32_t> first_face_;         // of each group, among those of `patches_`
  std::vector<std::uint32_t> value_;              // of each group; kNone: yet to come
};

}  // namespace whittle::attributes
