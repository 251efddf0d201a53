/// \file
/// The one-rings of all vertices, in order around each.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/parallel.hh"

namespace whittle {

/// The neighbours of a vertex v, counter-clockwise. `ring[i]`, `ring[i + 1]` and v are face i, for every i
/// below `n_faces()`; a closed ring repeats its first neighbour for that at `ring[n_faces()]`.
class Ring {
 public:
  Ring(const std::uint32_t* first, std::size_t n_faces, bool is_closed)
      : first_(first), n_faces_(n_faces), is_closed_(is_closed) {}

  const std::uint32_t* begin() const { return first_; }
  const std::uint32_t* end() const { return first_ + size(); }
  std::size_t size() const { return n_faces_ + (n_faces_ > 0 && !is_closed_); }  ///< neighbours, each once
  std::size_t n_faces() const { return n_faces_; }
  bool is_closed() const { return is_closed_; }
  std::uint32_t operator[](std::size_t i) const { return first_[i]; }
  std::uint32_t front() const { return first_[0]; }
  std::uint32_t back() const { return first_[size() - 1]; }

 private:
  const std::uint32_t* first_;
  std::size_t n_faces_;
  bool is_closed_;
};

/// What the faces around a vertex form.
enum class RingShape : std::uint8_t {
  closed,   ///< a disc around it
  open,     ///< one fan: the vertex is on the boundary
  complex,  ///< neither: several fans, an edge with more than two faces, a face that names the vertex twice
  empty     ///< nothing: no face has it
};

/// The rings of all vertices in one array; 4 bytes a corner and 8 a vertex.
class Rings {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// \param triangles   all indices below `n_vertices`.
  /// \param with_faces  whether to keep which face is where, for `face()` and `corner()`.
  Rings(const std::vector<Triangle>& triangles, std::size_t n_vertices, bool with_faces,
        std::size_t n_threads)
      : first_(n_vertices + 1, 0), shapes_(n_vertices, RingShape::empty) {
    collect(triangles);
    if (with_faces) corners_.resize(ring_.size());
    for_each_part(n_vertices, n_threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        const std::size_t n = valence(v);
        if (n > 0)
          shapes_[v] = n <= kFew    ? order<kFew>(triangles, v)
                       : n <= kSome ? order<kSome>(triangles, v)
                                    : order<kMany>(triangles, v);
      }
    });
  }

  RingShape shape(std::uint32_t v) const { return shapes_[v]; }

  /// Empty where the shape is complex or empty.
  Ring operator[](std::uint32_t v) const {
    const bool is_ordered = shapes_[v] == RingShape::closed || shapes_[v] == RingShape::open;
    return {&ring_[first_[v]], is_ordered ? valence(v) : 0, shapes_[v] == RingShape::closed};
  }

  /// Which face the i-th of a ring is.
  std::uint32_t face(std::uint32_t v, std::size_t i) const { return corner(v, i) / 4; }
  /// Four times that face plus the corner where it has the vertex.
  std::uint32_t corner(std::uint32_t v, std::size_t i) const { return corners_[first_[v] + i]; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::size_t kFew = 8, kSome = 24, kMany = 0;

  /// The faces of one vertex, at most `N`: their corners there, the vertices after and before, and which face
  /// comes next.
  template <std::size_t N>
  struct Fan {
    std::array<std::uint32_t, N> corner, next, previous, follower;
    std::size_t n_followed = 0, sum = 0;  // how many follow another, and the sum of their places
    explicit Fan(std::size_t /*n*/) {}
    bool link(std::size_t n);
  };

  std::size_t valence(std::uint32_t v) const { return first_[v + 1] - first_[v] - 1; }
  void collect(const std::vector<Triangle>& triangles);
  template <std::size_t N>
  RingShape order(const std::vector<Triangle>& triangles, std::uint32_t v);

  std::vector<std::uint32_t> first_;  // of v: its faces and one more
  std::vector<std::uint32_t> ring_, corners_;
  std::vector<RingShape> shapes_;
};

/// Puts the faces of each vertex into its place, in index order; a face as four times its index plus the
/// corner, which spares `order` to look for the corner.
inline void Rings::collect(const std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) ++first_[v + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1] + 1;
  ring_.resize(first_.back());
  // Filling moves each start to the end of its faces, one short of the next start.
  for (std::uint32_t f = 0; f < triangles.size(); ++f)
    for (std::uint32_t i = 0; i < 3; ++i) ring_[first_[triangles[f][i]]++] = 4 * f + i;
  for (std::size_t v = first_.size() - 1; v > 0; --v) first_[v] = first_[v - 1] + 1;
  first_[0] = 0;
}

/// Finds for each face the one that begins at the neighbour where it ends, kNone if there is none. With few
/// faces comparing all with all is the fastest: no branches, and compilers make it vector instructions.
/// \return false  two faces begin there.
template <std::size_t N>
bool Rings::Fan<N>::link(std::size_t n) {
  for (std::size_t i = n; i < N; ++i) {
    next[i] = kNone;
    previous[i] = kNone - 1;
  }
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

/// The same with any number of faces.
template <>
struct Rings::Fan<Rings::kMany> {
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

template <std::size_t N>
RingShape Rings::order(const std::vector<Triangle>& triangles, std::uint32_t v) {
  const std::size_t n = valence(v);
  std::uint32_t* const ring = &ring_[first_[v]];
  Fan<N> fan(n);
  constexpr std::array<std::uint8_t, 4> kNext{1, 2, 0, 1};
  bool is_degenerate = false;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t corner = ring[i] % 4, f = ring[i] / 4;
    fan.corner[i] = ring[i];
    fan.next[i] = triangles[f][kNext[corner]];
    fan.previous[i] = triangles[f][kNext[corner + 1]];
    is_degenerate |= fan.next[i] == v || fan.previous[i] == v || fan.next[i] == fan.previous[i];
  }
  if (is_degenerate || !fan.link(n)) return RingShape::complex;

  // An open fan begins at the one face that follows no other: the one missing in the sum of all followers.
  const bool is_closed = fan.n_followed == n;
  const std::size_t start = is_closed ? 0 : n * (n - 1) / 2 - fan.sum;
  if (fan.n_followed + 1 < n || start >= n) return RingShape::complex;

  // Whatever the sum has hidden shows here: a walk of n steps that ends as it should has been everywhere.
  std::uint32_t at = static_cast<std::uint32_t>(start);
  std::size_t i = 0;
  do {
    ring[i] = fan.next[at];
    if (!corners_.empty()) corners_[first_[v] + i] = fan.corner[at];
    ring[++i] = fan.previous[at];
    at = fan.follower[at];
  } while (at != kNone && at != start && i < n);
  if (i < n || at != (is_closed ? start : kNone)) return RingShape::complex;
  return is_closed ? RingShape::closed : RingShape::open;
}

}  // namespace whittle
