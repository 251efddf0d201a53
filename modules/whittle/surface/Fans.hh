/// \file
/// The faces around each vertex, in order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace whittle::detail {

/// What the faces around a vertex form.
enum class RingShape : std::uint8_t {
  closed,   ///< a disc around it
  open,     ///< one fan: the vertex is on the boundary
  complex,  ///< neither: several fans, an edge with more than two faces, a face that names the vertex twice
  empty     ///< nothing: no face has the vertex
};

/// The corners at each vertex; 4 bytes a corner and 8 a vertex.
///
/// A corner is one number: four times its face plus its place there, 0..2.
class Fans {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::size_t kMostTriangles = std::size_t{1} << 30;
  static constexpr std::uint32_t corner_of(std::uint32_t face, std::uint32_t place) {
    return 4 * face + place;
  }
  static constexpr std::uint32_t face_of(std::uint32_t corner) { return corner / 4; }
  static constexpr std::uint32_t place_of(std::uint32_t corner) { return corner % 4; }

  /// \param triangles  at most kMostTriangles, all indices below `n_vertices`.
  Fans(const std::vector<Triangle>& triangles, std::size_t n_vertices);

  std::size_t valence(std::uint32_t v) const { return first_[v + 1] - first_[v] - 1; }

  /// Goes around a vertex counter-clockwise, from where an open fan begins: calls `visit(i, corner, next,
  /// previous)` for the i-th face, with its corner at `v` and the vertices after and before that. Where the
  /// shape is complex, what was visited means nothing.
  template <typename Visit>
  RingShape walk(const std::vector<Triangle>& triangles, std::uint32_t v, Visit visit) const {
    const std::size_t n = valence(v);
    if (n == 0) return RingShape::empty;
    if (n <= kFew) return walk_some<kFew>(triangles, v, visit);
    return n <= kSome ? walk_some<kSome>(triangles, v, visit) : walk_some<kMany>(triangles, v, visit);
  }

  /// The corners at a vertex, by face index, and room for one more entry. After a walk the caller may
  /// overwrite them.
  std::uint32_t* places(std::uint32_t v) { return &corners_[first_[v]]; }
  const std::uint32_t* places(std::uint32_t v) const { return &corners_[first_[v]]; }
  /// The index of `places(v)[0]` in the array of all places.
  std::size_t begin(std::uint32_t v) const { return first_[v]; }
  std::size_t n_places() const { return corners_.size(); }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::size_t kFew = 8, kSome = 24, kMany = 0;

  /// The faces of one vertex, at most `N`: their corners there, the vertices after and before, and which face
  /// comes next. Unused entries hold numbers that match nothing.
  template <std::size_t N>
  struct Fan {
    std::array<std::uint32_t, N> corner, next, previous, follower;
    std::size_t n_followed = 0, sum = 0;  // how many follow another, and the sum of their places
    explicit Fan(std::size_t /*n*/) {
      next.fill(kNone);
      previous.fill(kNone - 1);
    }
    bool link(std::size_t n);
  };

  template <std::size_t N, typename Visit>
  RingShape walk_some(const std::vector<Triangle>& triangles, std::uint32_t v, Visit visit) const;

  std::vector<std::uint32_t> first_, corners_;
  bool degenerate_ = false;  // whether any triangle names a vertex twice
};

inline Fans::Fans(const std::vector<Triangle>& triangles, std::size_t n_vertices)
    : first_(n_vertices + 1, 0) {
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) ++first_[v + 1];
    degenerate_ |= t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1] + 1;
  corners_.resize(first_.back());
  // Filling moves each start to the end of its faces, one short of the next start.
  for (std::uint32_t f = 0; f < triangles.size(); ++f)
    for (std::uint32_t i = 0; i < 3; ++i) corners_[first_[triangles[f][i]]++] = corner_of(f, i);
  for (std::size_t v = first_.size() - 1; v > 0; --v) first_[v] = first_[v - 1] + 1;
  first_[0] = 0;
}

/// Finds for each face the one that begins at the neighbour where it ends, kNone if there is none. For few
/// faces comparing all pairs is fastest: it has no branches, and compilers vectorise it.
/// \return false  two faces begin at one neighbour.
template <std::size_t N>
bool Fans::Fan<N>::link(std::size_t /*n*/) {
  constexpr std::uint32_t kOne = 1u << 16;  // the sum of the matches' places, and above it how many they are
  std::array<std::uint32_t, N> matches{};
  for (std::uint32_t j = 0; j < N; ++j)
    for (std::size_t i = 0; i < N; ++i) matches[i] += next[j] == previous[i] ? kOne + j : 0;
  std::uint32_t most = 0, all = 0;
  for (std::size_t i = 0; i < N; ++i) {
    most = std::max(most, matches[i]);
    all += matches[i];
    follower[i] = matches[i] == 0 ? kNone : matches[i] % kOne;
  }
  n_followed = all / kOne;
  sum = all % kOne;
  return most < 2 * kOne;
}

/// The same for any number of faces, by sorting.
template <>
struct Fans::Fan<Fans::kMany> {
  std::vector<std::uint32_t> corner, next, previous, follower;
  std::size_t n_followed = 0, sum = 0;
  explicit Fan(std::size_t n) : corner(n), next(n), previous(n), follower(n) {}

  bool link(std::size_t n) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> begins(n);
    for (std::size_t i = 0; i < n; ++i) begins[i] = {next[i], static_cast<std::uint32_t>(i)};
    std::sort(begins.begin(), begins.end());
    for (std::size_t i = 0; i < n; ++i) {
      const auto found = std::lower_bound(begins.begin(), begins.end(), std::make_pair(previous[i], 0u));
      const bool follows = found != begins.end() && found->first == previous[i];
      if (follows && found + 1 != begins.end() && found[1].first == previous[i]) return false;
      follower[i] = follows ? found->second : kNone;
      n_followed += follows;
      sum += follows ? found->second : 0;
    }
    return true;
  }
};

template <std::size_t N, typename Visit>
RingShape Fans::walk_some(const std::vector<Triangle>& triangles, std::uint32_t v, Visit visit) const {
  const std::size_t n = valence(v);
  const std::uint32_t* const corners = places(v);
  Fan<N> fan(n);
  constexpr std::array<std::uint8_t, 4> kNext{1, 2, 0, 1};
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t corner = place_of(corners[i]), f = face_of(corners[i]);
    fan.corner[i] = corners[i];
    fan.next[i] = triangles[f][kNext[corner]];
    fan.previous[i] = triangles[f][kNext[corner + 1]];
  }
  if (degenerate_)
    for (std::size_t i = 0; i < n; ++i)
      if (fan.next[i] == v || fan.previous[i] == v || fan.next[i] == fan.previous[i])
        return RingShape::complex;
  if (!fan.link(n)) return RingShape::complex;

  // An open fan begins at the one face that follows no other: the one missing in the sum of all followers.
  const bool is_closed = fan.n_followed == n;
  const std::size_t start = is_closed ? 0 : n * (n - 1) / 2 - fan.sum;
  if (fan.n_followed + 1 < n || start >= n) return RingShape::complex;

  // The sum alone does not prove a single fan; a walk of n steps that ends as it should has seen all faces.
  std::uint32_t at = static_cast<std::uint32_t>(start);
  std::size_t i = 0;
  do {
    visit(i++, fan.corner[at], fan.next[at], fan.previous[at]);
    at = fan.follower[at];
  } while (at != kNone && at != start && i < n);
  if (i < n || at != (is_closed ? start : kNone)) return RingShape::complex;
  return is_closed ? RingShape::closed : RingShape::open;
}

}  // namespace whittle::detail
