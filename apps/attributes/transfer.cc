#include "attributes/transfer.hh"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "attributes/Sampler.hh"
#include "attributes/SeamTransfer.hh"
#include "attributes/Stars.hh"
#include "whittle/plan/Patches.hh"

namespace whittle::attributes {
namespace {

using Triangle = IndexedMesh::Triangle;

/// Carries one attribute over.
class Transfer {
 public:
  Transfer(const Attribute& in, const Decimation& d, const Stars& stars, const Members& members)
      : in_(in), d_(d), stars_(stars), members_(members), sampler_(in, d.before) {}

  Attribute run() {
    if (in_.per_vertex()) {
      for (std::uint32_t w = 0; w < d_.after.points.size(); ++w) carry_vertex(w);
    } else {
      begin_corners();
      for (std::uint32_t w = 0; w < d_.after.points.size(); ++w) carry_corners(w);
    }
    return sampler_.take(std::move(corners_));
  }

 private:
  /// The one vertex that became `w` and is still where it was, or nothing.
  const std::uint32_t* unchanged(std::uint32_t w) const {
    const auto [first, last] = members_.of(w);
    return last - first == 1 && d_.before.points[*first] == d_.after.points[w] ? first : nullptr;
  }

  void carry_vertex(std::uint32_t w) {
    if (const std::uint32_t* v = unchanged(w)) return sampler_.copy(*v);
    faces_ = stars_.around(members_.of(w));
    if (faces_.empty()) return sampler_.copy(*members_.of(w).first);
    sampler_.interpolate(d_.after.points[w], faces_);
  }

  void begin_corners() {
    corners_.resize(d_.after.triangles.size());
    after_ = Stars(d_.after);
    input_.emplace(d_.before.triangles, in_.corners, d_.before.points.size());
    patches_.emplace(*input_);
  }

  void carry_corners(std::uint32_t w) {
    known_.clear();
    const std::uint32_t* same = unchanged(w);
    if (!same) patches_->gather(members_.of(w));
    for (const std::uint32_t g : after_.of(w)) {
      const Triangle& t = d_.after.triangles[g];
      const std::uint32_t value = same ? kept(*same, d_.face_origin[g]) : merged(w, d_.face_origin[g]);
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == w) corners_[g][k] = value;
    }
  }

  /// The value that face `origin` has had at `v` all along.
  std::uint32_t kept(std::uint32_t v, std::uint32_t origin) {
    const Triangle& t = d_.before.triangles[origin];
    const std::uint32_t value =
        in_.corners[origin][static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin())];
    const auto [found, is_new] = known_.emplace(value, sampler_.n_values());
    if (is_new) sampler_.copy(value);
    return found->second;
  }

  /// The value that a face of the result has at `w`, where the face was `origin` before.
  std::uint32_t merged(std::uint32_t w, std::uint32_t origin) {
    const std::uint32_t patch = patches_->patch(patches_->place(origin));
    const auto [found, is_new] = known_.emplace(patch, sampler_.n_values());
    if (is_new) {
      faces_.clear();
      for (std::uint32_t i = 0; i < patches_->faces().size(); ++i)
        if (patches_->patch(i) == patch) faces_.push_back(patches_->faces()[i]);
      sampler_.interpolate(d_.after.points[w], faces_);
    }
    return found->second;
  }

  const Attribute& in_;
  const Decimation& d_;
  const Stars& stars_;
  const Members& members_;
  Sampler sampler_;
  Stars after_;
  std::vector<Triangle> corners_;
  std::optional<detail::WedgedFaces> input_;      // of an attribute of corners
  std::optional<detail::Patches> patches_;        // the same
  std::vector<std::uint32_t> faces_;              // where the current value comes from, ascending
  std::map<std::uint32_t, std::uint32_t> known_;  // new values at the current vertex, by old value or patch
};

/// Whether moving a vertex across its borders would tear it.
bool makes_seams(const Attribute& attribute, const SeamKinds& kinds) {
  if (attribute.per_vertex()) return false;
  return attribute.kind == Kind::texture || (attribute.kind == Kind::normal && kinds.normals) ||
         (attribute.kind == Kind::colour && kinds.colours);
}

/// With one number for values that are equal.
Attribute with_distinct_values(const Attribute& in) {
  std::vector<std::uint32_t> order(in.n_values()), first(in.n_values());
  std::iota(order.begin(), order.end(), 0u);
  const auto is_less = [&](std::uint32_t a, std::uint32_t b) {
    return std::lexicographical_compare(in.value(a), in.value(a) + in.components, in.value(b),
                                        in.value(b) + in.components);
  };
  std::stable_sort(order.begin(), order.end(), is_less);
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && !is_less(order[i - 1], order[i]) ? first[order[i - 1]] : order[i];
  Attribute out = in;
  for (Triangle& corners : out.corners)
    for (std::uint32_t& value : corners) value = first[value];
  return out;
}

/// Numbers the pairs of two numbers at each corner.
void combine(std::vector<Triangle>& numbers, const std::vector<Triangle>& others) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  for (std::size_t f = 0; f < numbers.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      numbers[f][k] =
          known.emplace(std::pair(numbers[f][k], others[f][k]), static_cast<std::uint32_t>(known.size()))
              .first->second;
}

}  // namespace

Attributes transfer(const Attributes& attributes, const Decimation& decimation, const SeamKinds& kinds) {
  Attributes out;
  if (attributes.empty()) return out;
  const Stars stars(decimation.before);
  const Members members(decimation.vertex_map, decimation.after.points.size());
  for (const Attribute& attribute : attributes)
    if (makes_seams(attribute, kinds))
      out.push_back(SeamTransfer(with_distinct_values(attribute), decimation).run());
    else
      out.push_back(Transfer(attribute, decimation, stars, members).run());
  return out;
}

std::vector<Triangle> seam_wedges(const Attributes& attributes, const SeamKinds& kinds,
                                  const std::vector<std::uint32_t>& areas) {
  std::vector<Triangle> out;
  for (const std::uint32_t area : areas) out.push_back({area, area, area});
  for (const Attribute& attribute : attributes) {
    if (!makes_seams(attribute, kinds)) continue;
    std::vector<Triangle> corners = with_distinct_values(attribute).corners;
    if (out.empty())
      out = std::move(corners);
    else
      combine(out, corners);
  }
  return out;
}

std::vector<IndexedMesh::Triangle> wedges(const IndexedMesh& mesh, const Attributes& attributes,
                                          const std::vector<std::uint32_t>& parts) {
  if (parts.empty() &&
      std::all_of(attributes.begin(), attributes.end(), [](const auto& a) { return a.per_vertex(); }))
    return {};
  std::map<std::vector<std::uint32_t>, std::uint32_t> known;
  std::vector<IndexedMesh::Triangle> out(mesh.triangles.size());
  std::vector<std::uint32_t> key;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      key.assign(1, mesh.triangles[f][k]);
      if (!parts.empty()) key.push_back(parts[f]);
      for (const Attribute& attribute : attributes)
        if (!attribute.per_vertex()) key.push_back(attribute.corners[f][k]);
      out[f][k] = known.emplace(key, static_cast<std::uint32_t>(known.size())).first->second;
    }
  return out;
}

Attributes rewedged(const Attributes& attributes, const std::vector<Triangle>& before,
                    const std::vector<Triangle>& after) {
  std::vector<std::pair<std::size_t, std::size_t>> corner_of;  // some corner of each wedge
  for (std::size_t f = 0; f < before.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      if (before[f][k] >= corner_of.size()) corner_of.resize(before[f][k] + std::size_t{1});
      corner_of[before[f][k]] = {f, k};
    }
  Attributes out = attributes;
  for (Attribute& attribute : out) {
    if (attribute.per_vertex()) continue;
    std::vector<Triangle> corners(after.size());
    for (std::size_t f = 0; f < after.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [old_face, old_corner] = corner_of[after[f][k]];
        corners[f][k] = attribute.corners[old_face][old_corner];
      }
    attribute.corners = std::move(corners);
  }
  return out;
}

}  // namespace whittle::attributes
