/// \file
/// Where the values at a vertex come from that others have merged into, on each side of the seams there.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "whittle/plan/Patches.hh"
#include "whittle/surface/Lists.hh"
#include "whittle/surface/triangle.hh"

namespace whittle::detail {

/// Finds the place in the input from which each corner of a vertex takes its values, so that nothing tears.
///
/// Inside a chart that is the nearest point of the chart's faces around the vertex's members, the vertices that became
/// it. On a seam each patch around it takes the values at a point of its border, and the two of a seam those at the
/// same one: the nearest on the edges between the two at the members. Where three charts or more meet and the corner
/// has moved along the seam of two of them, the others keep the values at the corner.
class SeamPlaces {
 public:
  /// A point of a face of the input: the shares of its corners, which add up to 1.
  struct Place {
    std::uint32_t face;
    std::array<double, 3> shares;
  };
  /// The corner of a face, by the face that it was in the input. Corners with the same wedge take the same values.
  struct Corner {
    std::uint32_t face, wedge;
  };

  /// The input, all of which must outlive this. \param points  of each vertex
  SeamPlaces(const std::vector<Eigen::Vector3d>& points, const WedgedFaces& faces)
      : points_(points), input_(faces), patches_(faces) {}

  /// Looks for the places of a vertex at `p`.
  /// \param members  the vertices that became it, ascending
  /// \param corners  of all faces that it has now; each face is one of those around the members
  void find(const Eigen::Vector3d& p, Lists::Range members, const std::vector<Corner>& corners);

  /// Corners take their values in groups, one for each side of the seams.
  std::size_t n_groups() const { return places_.size(); }
  /// The group of the i-th of the corners.
  std::uint32_t group(std::size_t i) const { return group_of_corner_[i]; }
  const Place& place(std::uint32_t group) const { return places_[group]; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// Where groups met in the input.
  struct Spot {
    double squared_distance;
    std::uint32_t seam;        ///< of `patches_`, where the place is on one; else kNone
    std::uint32_t vertex;      ///< the place, where it is one
    double share;              ///< on a seam, from its lower vertex to its higher one
    std::size_t first, count;  ///< of `meets_`, the groups that meet there; ascending, at least one
  };

  void find_groups(const std::vector<Corner>& corners);
  /// The group of the patch of the i-th face of `patches_`; kNone if nothing is left of it.
  std::uint32_t group_of(std::uint32_t i) const { return group_[i]; }
  bool is_open(std::uint32_t group) const { return places_[group].face == kNone; }

  void find_spots(const Eigen::Vector3d& p, Lists::Range members);
  void find_corner_spots(const Eigen::Vector3d& p, Lists::Range members, double longest);
  Place place_at(const Spot& spot, std::uint32_t group);
  Place nearest_place(const Eigen::Vector3d& p, std::uint32_t group);

  const std::vector<Eigen::Vector3d>& points_;
  const WedgedFaces& input_;
  Patches patches_;
  // At the current vertex:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> first_;  // of each wedge: a face of `patches_`
  std::uint32_t n_groups_ = 0;
  std::vector<std::uint32_t> group_, group_of_corner_;  // of each of the faces; of each corner
  std::vector<Place> places_;                           // of each group
  std::vector<Spot> spots_;
  std::vector<std::uint32_t> meets_;    // the groups of one spot after the other
  std::vector<std::uint32_t> corners_;  // the members on seams
};

inline void SeamPlaces::find(const Eigen::Vector3d& p, Lists::Range members,
                             const std::vector<Corner>& corners) {
  patches_.gather(members);
  find_groups(corners);
  places_.assign(n_groups_, {kNone, {}});
  spots_.clear();
  meets_.clear();
  if (places_.size() > 1) find_spots(p, members);
  // Those that met in one place together: the nearest place first, but where there are only two, one where they met.
  for (;;) {
    const Spot* best = nullptr;
    std::tuple<bool, double, std::ptrdiff_t> least;
    for (const Spot& spot : spots_) {
      std::ptrdiff_t n = 0;
      for (std::size_t i = 0; i < spot.count; ++i) n += is_open(meets_[spot.first + i]);
      const std::tuple rank(places_.size() == 2 && n < 2, spot.squared_distance, -n);
      if (n == 0 || (best && !(rank < least))) continue;
      best = &spot;
      least = rank;
    }
    if (best == nullptr) break;
    for (std::size_t i = 0; i < best->count; ++i)
      if (const std::uint32_t group = meets_[best->first + i]; is_open(group))
        places_[group] = place_at(*best, group);
  }
  for (std::uint32_t group = 0; group < places_.size(); ++group)
    if (is_open(group)) places_[group] = nearest_place(p, group);
}

/// The patches of faces whose corners have one wedge make a group.
inline void SeamPlaces::find_groups(const std::vector<Corner>& corners) {
  first_.clear();
  group_of_corner_.clear();
  for (const Corner& corner : corners) {
    const std::uint32_t i = patches_.place(corner.face);
    const auto known = std::find_if(first_.begin(), first_.end(),
                                    [&](const auto& entry) { return entry.first == corner.wedge; });
    if (known == first_.end())
      first_.emplace_back(corner.wedge, i);
    else
      patches_.join(known->second, i);
  }
  n_groups_ = 0;
  group_.assign(patches_.faces().size(), kNone);
  for (const auto& entry : first_)
    if (std::uint32_t& group = group_[patches_.patch(entry.second)]; group == kNone) group = n_groups_++;
  // A patch is the least of its faces.
  for (std::uint32_t i = 0; i < group_.size(); ++i) group_[i] = group_[patches_.patch(i)];
  for (const Corner& corner : corners) group_of_corner_.push_back(group_of(patches_.place(corner.face)));
}

inline void SeamPlaces::find_spots(const Eigen::Vector3d& p, Lists::Range members) {
  double longest = 0;
  for (std::uint32_t s = 0; s < patches_.seams().size(); ++s) {
    const auto& seam = patches_.seams()[s];
    const Eigen::Vector3d a = points_[seam.low], e = points_[seam.high] - a;
    const double square = e.squaredNorm();
    const double share = square > 0 ? std::clamp((p - a).dot(e) / square, 0.0, 1.0) : 0;
    longest = std::max(longest, square);
    const auto [one, other] = std::minmax({group_of(seam.first.face), group_of(seam.second.face)});
    if (one == kNone) continue;
    const std::size_t first = meets_.size();
    meets_.push_back(one);
    if (other != one && other != kNone) meets_.push_back(other);
    spots_.push_back({(a + share * e - p).squaredNorm(), s, kNone, share, first, meets_.size() - first});
  }
  if (places_.size() > 2) find_corner_spots(p, members, longest);
}

/// What a member alone can tell: where three patches or more met. All of them stay there as long as it hardly moves.
/// \param longest  square of the longest seam edge's length
inline void SeamPlaces::find_corner_spots(const Eigen::Vector3d& p, Lists::Range members, double longest) {
  constexpr double kHardly = 1e-3;  // of an edge
  corners_.clear();
  for (const auto& seam : patches_.seams())
    for (const std::uint32_t v : {seam.low, seam.high})
      if (std::binary_search(members.first, members.second, v)) corners_.push_back(v);
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  for (const std::uint32_t v : corners_) {
    const double square = (points_[v] - p).squaredNorm();
    const std::size_t first = meets_.size();
    const auto begin = [&] { return meets_.begin() + static_cast<std::ptrdiff_t>(first); };
    const auto [corner, last] = input_.corners.of(v);
    for (const std::uint32_t* at = corner; at != last; ++at) {
      const std::uint32_t group = group_of(patches_.place(*at / 3));
      if (group != kNone && std::find(begin(), meets_.end(), group) == meets_.end()) meets_.push_back(group);
    }
    if (meets_.size() == first) continue;
    std::sort(begin(), meets_.end());
    spots_.push_back(
        {square > kHardly * kHardly * longest ? square : 0, kNone, v, 0, first, meets_.size() - first});
  }
}

/// The place of one of the groups that meet at a spot, on the group's own side.
inline auto SeamPlaces::place_at(const Spot& spot, std::uint32_t group) -> Place {
  Place place{kNone, {0, 0, 0}};
  if (spot.vertex == kNone) {
    const auto& seam = patches_.seams()[spot.seam];
    const auto& side = group_of(seam.first.face) == group ? seam.first : seam.second;
    place.face = patches_.faces()[side.face];
    place.shares[side.at_low] = 1 - spot.share;
    place.shares[side.at_high] = spot.share;
    return place;
  }
  for (std::uint32_t i = 0; i < patches_.faces().size() && place.face == kNone; ++i) {
    const auto& t = input_.triangles[patches_.faces()[i]];
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), spot.vertex) - t.begin());
    if (k == 3 || group_of(i) != group) continue;
    place.face = patches_.faces()[i];
    place.shares[k] = 1;
  }
  return place;
}

/// The nearest point of a group's faces.
inline auto SeamPlaces::nearest_place(const Eigen::Vector3d& p, std::uint32_t group) -> Place {
  std::uint32_t nearest = kNone;
  double least = HUGE_VAL;
  Eigen::Vector3d at = p;
  for (std::uint32_t i = 0; i < patches_.faces().size(); ++i) {
    if (group_of(i) != group) continue;
    const std::uint32_t f = patches_.faces()[i];
    const auto& [a, b, c] = input_.triangles[f];
    if (nearest == kNone) nearest = f;  // whatever its shape
    const Eigen::Vector3d q = closest_point(p, points_[a], points_[b], points_[c]);
    const double distance = (q - p).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = f;
    at = q;
  }
  const auto& [a, b, c] = input_.triangles[nearest];
  return {nearest, shares(at, points_[a], points_[b], points_[c])};
}

}  // namespace whittle::detail
