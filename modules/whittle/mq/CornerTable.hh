/// \file
/// A triangle mesh that collapses edges fast.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/mq/Corner.hh"
#include "whittle/surface/Fans.hh"
#include "whittle/surface/threads.hh"

namespace whittle::mq {

/// Triangles with their three vertices and three neighbours, and one corner of each vertex.
///
///         l           Half-edge c goes from a to b; its opposite, `twin(c)`, from b to a. The corners around
///         a
///        / \          vertex are c, twin(previous(c)), and so on, counter-clockwise; of a boundary vertex
///       / c \         `first` is the one where that begins.
///      a --- b
///
/// \tparam Notes  eight bytes that the user keeps with each face.
template <typename Notes>
class CornerTableT {
 public:
  struct Face {
    std::array<std::uint32_t, 3> vertex;  ///< kDead in the first of a face that has vanished
    std::array<Corner, 3> twin;  ///< of the half-edge that starts at each corner; kNoCorner at a boundary
    Notes notes;
  };
  static_assert(sizeof(Face) == corner_of(1) * sizeof(std::uint32_t));
  static constexpr std::uint32_t kDead = 0xffffffffu;
  static constexpr std::size_t kMostFaces = (std::size_t{1} << 32) / corner_of(1);

  CornerTableT() = default;

  /// A vertex has a ring if its faces form a disc or one fan; a half-edge between two that have none has no
  /// twin.
  /// \param triangles  at most kMostFaces, all indices below `n_vertices`.
  CornerTableT(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t n_vertices,
               detail::Crew& crew);

  Face& face(Corner c) { return faces_[face_of(c)]; }
  const Face& face(Corner c) const { return faces_[face_of(c)]; }
  Notes& notes(Corner c) { return face(c).notes; }
  const Notes& notes(Corner c) const { return face(c).notes; }
  const std::vector<Face>& faces() const { return faces_; }
  std::size_t n_faces() const { return faces_.size(); }
  std::size_t n_vertices() const { return first_.size(); }
  bool is_dead(Corner c) const { return face(c).vertex[0] == kDead; }
  std::uint32_t vertex(Corner c) const { return words()[c]; }
  Corner twin(Corner c) const { return words()[c + 3]; }

  /// A corner of a vertex; at the boundary the first. kNoCorner where it has no ring.
  Corner first(std::uint32_t v) const { return first_[v]; }

  /// Whether the fan of a vertex with a ring is open.
  bool is_open(std::uint32_t v) const { return twin(first_[v]) == kNoCorner; }

  /// The corner after `c` around its vertex, kNoCorner at the end of an open fan.
  Corner around(Corner c) const { return twin(previous(c)); }

  /// Merges the end of half-edge `c` into its start. The link condition must hold.
  void collapse(Corner c);

 private:
  /// Removes the face of `c`, whose half-edge `c` has shrunk to a point: the neighbours across its other two
  /// edges become each other's twins.
  void close(Corner c);

  void set_twin(Corner c, Corner twin) {
    if (c != kNoCorner) words()[c + 3] = twin;
  }

  /// All faces in a row, eight words each: the word at a corner's number is its vertex, the third after it
  /// its twin. That is one instruction, where a face and a place in it would be four.
  std::uint32_t* words() { return reinterpret_cast<std::uint32_t*>(faces_.data()); }
  const std::uint32_t* words() const { return reinterpret_cast<const std::uint32_t*>(faces_.data()); }

  std::vector<Face> faces_;
  std::vector<Corner> first_;
};

template <typename Notes>
inline CornerTableT<Notes>::CornerTableT(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                         std::size_t n_vertices, detail::Crew& crew)
    : first_(n_vertices, kNoCorner) {
  using detail::Fans, detail::RingShape;
  faces_.reserve(triangles.size());
  for (const Fans::Triangle& t : triangles) faces_.push_back({t, {kNoCorner, kNoCorner, kNoCorner}, {}});
  const Fans fans(triangles, n_vertices);
  const auto own = [](std::uint32_t c) { return corner_of(Fans::face_of(c)) + Fans::place_of(c); };
  // Each half-edge gets its twin at the vertex where it starts.
  constexpr std::size_t kAtOnce = 1024;
  crew.each_range(n_vertices, kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
      Corner last = kNoCorner;
      const auto shape =
          fans.walk(triangles, v, [&](std::size_t i, std::uint32_t place, std::uint32_t, std::uint32_t) {
            const Corner c = own(place);
            if (i == 0)
              first_[v] = c;
            else
              set_twin(c, previous(last));
            last = c;
          });
      if (shape == RingShape::closed) set_twin(first_[v], previous(last));
      if (shape != RingShape::complex) continue;
      first_[v] = kNoCorner;
      for (std::size_t i = 0; i < fans.valence(v); ++i) set_twin(own(fans.places(v)[i]), kNoCorner);
    }
  });
  bool complete = true;
  for (std::uint32_t v = 0; v < n_vertices; ++v) complete &= first_[v] != kNoCorner || fans.valence(v) == 0;
  // Where the start has no ring, at the vertex where the half-edge ends.
  for (std::size_t f = 0; !complete && f < triangles.size(); ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3; ++c)
      if (twin(c) != kNoCorner && first_[vertex(twin(c))] == kNoCorner) set_twin(twin(c), c);
}

template <typename Notes>
inline void CornerTableT<Notes>::collapse(Corner c) {
  const Corner d = twin(c);
  const std::uint32_t to = vertex(c), from = vertex(next(c));
  const auto in_face_of = [](Corner at, Corner edge) {
    return edge != kNoCorner && face_of(at) == face_of(edge);
  };

  // The fan of the merged vertex begins where that of the open one of the two begins; on a boundary edge,
  // where `to` begins and `from` ends, where that of `from` does; in a disc, anywhere. If that face vanishes,
  // then after it.
  Corner first = d == kNoCorner || is_open(from) ? first_[from] : is_open(to) ? first_[to] : c;
  if (in_face_of(first, c))
    first = twin(previous(c));
  else if (in_face_of(first, d))
    first = twin(previous(d));

  for (Corner at = first_[from]; at != kNoCorner;) {
    words()[at] = to;
    at = around(at);
    if (at == first_[from]) break;
  }
  close(c);
  if (d != kNoCorner) close(d);
  first_[from] = kNoCorner;
  first_[to] = first;
}

template <typename Notes>
inline void CornerTableT<Notes>::close(Corner c) {
  const Corner left = twin(next(c)), right = twin(previous(c)), tip = previous(c);
  set_twin(left, right);
  set_twin(right, left);
  if (first_[vertex(tip)] == tip)
    first_[vertex(tip)] = left;  // across the edge that the tip's fan goes on by
  face(c).vertex[0] = kDead;
}

}  // namespace whittle::mq
