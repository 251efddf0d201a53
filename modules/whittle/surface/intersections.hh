/// \file
/// Which faces of a mesh intersect.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "whittle/surface/FaceTree.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/meeting.hh"
#include "whittle/surface/threads.hh"

namespace whittle {

/// Two faces by their numbers, the smaller one first.
using FacePair = std::array<std::uint32_t, 2>;

/// Pairs of faces that intersect.
struct Intersections {
  std::vector<FacePair> pairs;  ///< in order
  bool complete = true;         ///< there are no more, and none has been left unlooked at
};

namespace detail {

/// \param most_looks  pairs that are looked at for a block of some thousand faces
template <typename Place>
Intersections find_intersections(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                 const Place& place, std::size_t most, Crew& crew,
                                 std::size_t most_looks = std::size_t{1} << 20) {
  const FaceTree tree(triangles, place, crew);
  constexpr std::size_t kLeaves = 256,
                        kBlocks = 8;  // at once; the result depends on them, not on the threads
  Intersections out;
  for (std::size_t first = 0; first < tree.n_leaves() && out.complete; first += kLeaves * kBlocks) {
    const std::size_t n = std::min(tree.n_leaves() - first, kLeaves * kBlocks);
    std::array<std::vector<FacePair>, kBlocks> found;
    std::array<bool, kBlocks> given_up{};
    crew.each_range(n, kLeaves, [&](std::size_t begin, std::size_t end) {
      std::vector<FacePair>& pairs = found[begin / kLeaves];
      std::size_t looks = 0;
      const auto look = [&](std::uint32_t f, std::uint32_t g) {
        if (++looks > most_looks) {
          given_up[begin / kLeaves] = true;
          return false;
        }
        if (!faces_intersect(triangles[f], triangles[g], place)) return true;
        pairs.push_back({std::min(f, g), std::max(f, g)});
        return pairs.size() <= most;
      };
      for (std::size_t leaf = first + begin; leaf < first + end; ++leaf)
        if (!tree.pairs_of(leaf, look)) break;
    });
    for (std::size_t block = 0; block < kBlocks; ++block) {
      const auto& pairs = found[block];
      const std::size_t room = most - out.pairs.size(), taken = std::min(room, pairs.size());
      out.pairs.insert(out.pairs.end(), pairs.begin(),
                       std::next(pairs.begin(), static_cast<std::ptrdiff_t>(taken)));
      out.complete &= taken == pairs.size() && !given_up[block];
    }
  }
  std::sort(out.pairs.begin(), out.pairs.end());
  return out;
}

}  // namespace detail

/// Finds the pairs of faces that have a point in common beside the vertices and edges that they share: they run through one
/// another, overlap, or touch. Decided exactly (orientation.hh says for which coordinates). Vertices are shared by their
/// numbers, so two vertices at one place touch; a face without area, its corners exactly on a line, intersects nothing.
/// Where more than some thousand faces are near each of as many, as in a star of thin faces around a point, the rest is not
/// looked at, and the answer not complete.
/// \param most     stop at so many pairs; there may be as many as half the square of the number of faces
/// \param threads  0: as many as the machine has; the result is the same for any number
/// \throw InvalidMesh  a vertex that is not there; a coordinate of a face that is not finite.
template <typename Real>
Intersections intersections(const IndexedMeshT<Real>& mesh, std::size_t most = 1000000,
                            std::size_t threads = 0) {
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) {
      if (v >= mesh.points.size()) throw InvalidMesh("intersections: a face has a vertex that is not there");
      if (!mesh.points[v].allFinite()) throw InvalidMesh("intersections: a coordinate is not finite");
    }
  detail::Crew crew(std::min(detail::thread_count(threads), 1 + mesh.triangles.size() / 4096));
  const auto place = [&](std::uint32_t v) -> Eigen::Vector3d {
    return mesh.points[v].template cast<double>();
  };
  return detail::find_intersections(mesh.triangles, place, most, crew);
}

}  // namespace whittle
