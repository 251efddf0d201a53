#include "attributes/SeamTransfer.hh"

#include <algorithm>
#include <utility>

#include "whittle/plan/merged_wedges.hh"

namespace whittle::attributes {

SeamTransfer::SeamTransfer(const Attribute& in, const Decimation& d)
    : in_(in),
      d_(d),
      sampler_(in, d.before),
      members_(d.after.points.size(), d.vertex_map.size(), [&](std::size_t v) { return d.vertex_map[v]; }),
      corners_(detail::Lists::of_corners(d.after.triangles, d.after.points.size())),
      input_(d.before.triangles, in.corners, d.before.points.size()),
      places_(d.before.points, input_),
      wedges_(detail::WedgeMerger(
                  {d.before.triangles, d.after.triangles, d.vertex_map, d.face_origin, d.after.points.size()},
                  input_)
                  .run()),
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
  merged_.clear();
  for (const std::uint32_t* c = corners.first; c != corners.second; ++c)
    merged_.push_back({d_.face_origin[*c / 3], wedges_[*c / 3][*c % 3]});
  places_.find(p, members, merged_);
  const std::uint32_t first = sampler_.n_values();
  for (std::uint32_t group = 0; group < places_.n_groups(); ++group) {
    const auto& place = places_.place(group);
    sampler_.add(place.face, place.shares);
  }
  for (std::size_t i = 0; i < merged_.size(); ++i)
    out_[corners.first[i] / 3][corners.first[i] % 3] = first + places_.group(i);
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

}  // namespace whittle::attributes
