#include "attributes/SeamTransfer.hh"

#include <algorithm>
#include <tuple>
#include <utility>

#include "whittle/plan/merged_wedges.hh"

namespace whittle::attributes {

SeamTransfer::SeamTransfer(const Attribute& in, const Decimation& d)
    : in_(in),
      d_(d),
      sampler_(in, d.before),
      members_(d.after.points.size(), d.vertex_map.size(), [&](std::size_t v) { return d.vertex_map[v]; }),
      corners_(d.after.points.size(), 3 * d.after.triangles.size(),
               [&](std::size_t i) { return d.after.triangles[i / 3][i % 3]; }),
      patches_(d.before.triangles, in.corners, d.before.points.size()),
      wedges_(merged_wedges(
          {d.before.triangles, d.after.triangles, d.vertex_map, d.face_origin, d.after.points.size()},
          in.corners)),
      out_(d.after.triangles.size()) {}

Attribute SeamTransfer::run() {
  for (std::uint32_t w = 0; w < d_.after.points.size(); ++w) carry(w);
  return sampler_.take(std::move(out_));
}

void SeamTransfer::carry(std::uint32_t w) {
  const auto members = members_.of(w), corners = corners_.of(w);
  if (corners.first == corners.second) return;
  const Eigen::Vector3d& p = d_.after.points[w];
  if (members.second - members.first == 1 && d_.before.points[*members.first] == p)
    return keep(*members.first, corners);
  patches_.gather(members);
  find_groups(corners);
  place_groups(p, members);
  for (const std::uint32_t* c = corners.first; c != corners.second; ++c)
    out_[*c / 3][*c % 3] = value_[known_.at(wedges_[*c / 3][*c % 3])];
}

/// The values that the faces have had at `v` all along.
void SeamTransfer::keep(std::uint32_t v, detail::Lists::Range corners) {
  known_.clear();
  for (const std::uint32_t* c = corners.first; c != corners.second; ++c) {
    const std::uint32_t origin = d_.face_origin[*c / 3];
    const auto& t = d_.before.triangles[origin];
    const std::uint32_t value =
        in_.corners[origin][static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin())];
    const auto [found, is_new] = known_.emplace(value, sampler_.n_values());
    if (is_new) sampler_.copy(value);
    out_[*c / 3][*c % 3] = found->second;
  }
}

/// Those corners that have one wedge make a group, and so do the patches of their faces.
void SeamTransfer::find_groups(detail::Lists::Range corners) {
  known_.clear();
  group_.clear();
  first_face_.clear();
  for (const std::uint32_t* c = corners.first; c != corners.second; ++c) {
    const std::uint32_t face = patches_.place(d_.face_origin[*c / 3]);
    const auto [found, is_new] =
        known_.emplace(wedges_[*c / 3][*c % 3], static_cast<std::uint32_t>(first_face_.size()));
    if (is_new) first_face_.push_back(face);
    patches_.join(first_face_[found->second], face);
  }
  for (std::uint32_t g = 0; g < first_face_.size(); ++g) group_.emplace(patches_.patch(first_face_[g]), g);
  value_.assign(first_face_.size(), kNone);
}

std::optional<std::uint32_t> SeamTransfer::group_of(std::uint32_t i) {
  const auto found = group_.find(patches_.patch(i));
  if (found == group_.end()) return std::nullopt;
  return found->second;
}

auto SeamTransfer::spots(const Eigen::Vector3d& p, detail::Lists::Range members) -> std::vector<Spot> {
  std::vector<Spot> spots;
  const auto add = [&](Spot spot) {
    std::sort(spot.groups.begin(), spot.groups.end());
    spot.groups.erase(std::unique(spot.groups.begin(), spot.groups.end()), spot.groups.end());
    if (!spot.groups.empty()) spots.push_back(std::move(spot));
  };
  const auto& points = d_.before.points;
  double longest = 0;
  for (std::uint32_t s = 0; s < patches_.seams().size(); ++s) {
    const auto& seam = patches_.seams()[s];
    const Eigen::Vector3d a = points[seam.low], e = points[seam.high] - a;
    const double square = e.squaredNorm();
    const double share = square > 0 ? std::clamp((p - a).dot(e) / square, 0.0, 1.0) : 0;
    longest = std::max(longest, square);
    Spot spot{(a + share * e - p).squaredNorm(), {}, s, kNone, share};
    for (const std::uint32_t face : {seam.first.face, seam.second.face})
      if (const auto group = group_of(face)) spot.groups.push_back(*group);
    add(std::move(spot));
  }
  // What a member alone can tell: where three patches or more met. All of them stay there as long as it hardly moves.
  constexpr double kHardly = 1e-3;  // of an edge
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups_at;
  if (first_face_.size() > 2)
    for (const auto& seam : patches_.seams())
      for (const std::uint32_t v : {seam.low, seam.high})
        if (std::binary_search(members.first, members.second, v)) groups_at[v];
  for (std::uint32_t i = 0; !groups_at.empty() && i < patches_.faces().size(); ++i)
    for (const std::uint32_t v : d_.before.triangles[patches_.faces()[i]]) {
      const auto found = groups_at.find(v);
      if (found == groups_at.end()) continue;
      if (const auto group = group_of(i)) found->second.push_back(*group);
    }
  for (auto& [v, groups] : groups_at) {
    const double square = (points[v] - p).squaredNorm();
    add({square > kHardly * kHardly * longest ? square : 0, std::move(groups), kNone, v, 0});
  }
  return spots;
}

/// Adds the value of a group at a place.
void SeamTransfer::add_value(std::uint32_t group, const Spot& spot) {
  value_[group] = sampler_.n_values();
  if (spot.vertex == kNone) {
    const auto& seam = patches_.seams()[spot.seam];
    const auto& side = group_of(seam.first.face) == group ? seam.first : seam.second;
    const auto& corners = in_.corners[patches_.faces()[side.face]];
    return sampler_.between(corners[side.at_low], corners[side.at_high], spot.share);
  }
  for (std::uint32_t i = 0; i < patches_.faces().size(); ++i) {
    const std::uint32_t f = patches_.faces()[i];
    const auto& t = d_.before.triangles[f];
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), spot.vertex) - t.begin());
    if (k < 3 && group_of(i) == group) return sampler_.copy(in_.corners[f][k]);
  }
}

/// Gives each group a value, those together that met in one place: the nearest place first, but where there are only
/// two groups, a place where they met.
void SeamTransfer::place_groups(const Eigen::Vector3d& p, detail::Lists::Range members) {
  const auto is_open = [&](std::uint32_t group) { return value_[group] == kNone; };
  const auto candidates = first_face_.size() > 1 ? spots(p, members) : std::vector<Spot>();
  for (;;) {
    const Spot* best = nullptr;
    std::tuple<bool, double, std::ptrdiff_t> least;
    for (const Spot& spot : candidates) {
      const auto n = std::count_if(spot.groups.begin(), spot.groups.end(), is_open);
      const std::tuple rank(value_.size() == 2 && n < 2, spot.squared_distance, -n);
      if (n == 0 || (best && !(rank < least))) continue;
      best = &spot;
      least = rank;
    }
    if (best == nullptr) break;
    for (const std::uint32_t group : best->groups)
      if (is_open(group)) add_value(group, *best);
  }
  std::vector<std::uint32_t> faces;
  for (std::uint32_t group = 0; group < value_.size(); ++group) {
    if (!is_open(group)) continue;
    faces.clear();
    for (std::uint32_t i = 0; i < patches_.faces().size(); ++i)
      if (group_of(i) == group) faces.push_back(patches_.faces()[i]);
    value_[group] = sampler_.n_values();
    sampler_.interpolate(p, faces);
  }
}

}  // namespace whittle::attributes
