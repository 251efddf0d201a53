/// \file
/// Memory that collapses will need soon.
#pragma once

#include <array>
#include <cstddef>

namespace whittle::detail {

/// Asks for the half-edges around the vertices of collapses that come soon. A plan goes all over the mesh, and
/// a walk around a vertex finds each half-edge through the one before it, so every step would wait for memory.
/// Here the walks of several collapses are under way at once, each a step further with every collapse. Only
/// time depends on it.
/// \tparam both_ends  whether the ring of the survivor is walked around, too, as the test of legality does.
template <typename Mesh, bool both_ends>
class RingPrefetchT {
 public:
  using VertexHandle = typename Mesh::VertexHandle;
  using HalfedgeHandle = typename Mesh::HalfedgeHandle;

  /// How many collapses ahead the caller announces them.
  static constexpr std::size_t kAhead = 16;

  explicit RingPrefetchT(const Mesh& mesh) : mesh_(mesh) {}

  /// Called once for each collapse, with the vertices of the one that comes `kAhead` later.
  void announce(VertexHandle from, VertexHandle to) {
    walks_[newest_ = (newest_ + 1) % kAhead] = {from, to, HalfedgeHandle(), HalfedgeHandle()};
    prefetch(&mesh_.vertex(from));
    prefetch(&mesh_.vertex(to));
    prefetch(&mesh_.point(from));
    prefetch(&mesh_.point(to));
    Walk& begun = walks_[(newest_ + kAhead - kBegin) % kAhead];
    if (begun.from.is_valid()) {
      begun.around_from = mesh_.halfedge_handle(begun.from);
      if (both_ends) begun.around_to = mesh_.halfedge_handle(begun.to);
    }
    for (std::size_t age = kBegin; age < kBegin + kSteps; ++age) {
      Walk& walk = walks_[(newest_ + kAhead - age) % kAhead];
      step(walk.around_from, age > kBegin);
      if (both_ends) step(walk.around_to, age > kBegin);
    }
  }

 private:
  static constexpr std::size_t kBegin = 3,
                               kSteps = 10;  // when its vertices have arrived; most rings have fewer
  static_assert(kBegin + kSteps < kAhead);

  struct Walk {
    VertexHandle from, to;
    HalfedgeHandle around_from, around_to;
  };

  static void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
#endif
  }

  /// To the next half-edge around the vertex, or just to the one that is there.
  void step(HalfedgeHandle& h, bool on) const {
    if (!h.is_valid()) return;
    if (on) h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
    if (h.is_valid()) prefetch(&mesh_.halfedge(h));
  }

  const Mesh& mesh_;
  std::array<Walk, kAhead> walks_;
  std::size_t newest_ = 0;
};

}  // namespace whittle::detail
