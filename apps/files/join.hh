/// \file
/// Vertices at one place, which files have along seams and creases, become one.
#pragma once

#include <cstdint>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

struct JoinOptions {
  /// How far apart vertices at one place may lie, model units; each takes the first one's coordinates
  double weld = 0;
  /// Whether faces that are turned against each other are joined, too, for the repair to turn them
  bool turns = false;
  /// Whether nothing says which vertices are the same, as in STL: two faces at an edge are joined however they are
  /// turned, and faces on the same three places have the same vertices, for the repair to leave them out
  bool soup = false;
};

/// Joins vertices at one place where faces meet across an edge there: one side up, one down. Where more than two sides
/// meet, those of one piece belong together, then those between which the surface turns least. Vertices that are at
/// one place without a common edge stay apart, and so do all whose joining would give an edge a third face: but for
/// what the options say, what was manifold stays manifold. Attributes that differ are at the corners afterwards. A
/// face two of whose corners become one is left out.
/// \throw Fault  a weld that is negative, not finite, or more than 1 % of the bounding box's diagonal
/// \pre every index is in range
/// \param place  for each vertex the first at its place, where that has been looked for already; else none
void join(MeshFile& file, const JoinOptions& options, std::vector<std::uint32_t> place = {});

}  // namespace whittle::files
