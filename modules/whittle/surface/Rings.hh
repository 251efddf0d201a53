/// \file
/// The one-rings of all vertices, in order around each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/Fans.hh"
#include "whittle/surface/threads.hh"

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

namespace detail {

/// The rings of all vertices in one array; 4 bytes a corner and 8 a vertex.
class Rings {
 public:
  using Triangle = Fans::Triangle;

  /// \param triangles   all indices below `n_vertices`.
  /// \param with_faces  whether to keep which face is where, for `face()`.
  Rings(const std::vector<Triangle>& triangles, std::size_t n_vertices, bool with_faces, Crew& crew)
      : fans_(triangles, n_vertices), faces_(with_faces ? fans_.n_places() : 0), shapes_(n_vertices) {
    constexpr std::size_t kAtOnce = 1024;
    crew.each_range(n_vertices, kAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        std::uint32_t* const ring = fans_.places(v);
        std::uint32_t* const faces = with_faces ? &faces_[fans_.begin(v)] : nullptr;
        shapes_[v] =
            fans_.walk(triangles, v,
                       [=](std::size_t k, std::uint32_t corner, std::uint32_t next, std::uint32_t previous) {
                         ring[k] = next;
                         ring[k + 1] = previous;
                         if (faces != nullptr) faces[k] = Fans::face_of(corner);
                       });
      }
    });
  }

  RingShape shape(std::uint32_t v) const { return shapes_[v]; }

  /// Empty where the shape is complex or empty.
  Ring operator[](std::uint32_t v) const {
    const bool is_ordered = shapes_[v] == RingShape::closed || shapes_[v] == RingShape::open;
    return {fans_.places(v), is_ordered ? fans_.valence(v) : 0, shapes_[v] == RingShape::closed};
  }

  /// Which face the i-th of a ring is.
  std::uint32_t face(std::uint32_t v, std::size_t i) const { return faces_[fans_.begin(v) + i]; }

 private:
  Fans fans_;                         // the places hold the rings
  std::vector<std::uint32_t> faces_;  // in the order of the rings
  std::vector<RingShape> shapes_;
};

}  // namespace detail

}  // namespace whittle
