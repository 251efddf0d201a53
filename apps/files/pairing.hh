/// \file
/// Which vertices at one place belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "files/join.hh"

namespace whittle::files {

struct Joined {
  std::vector<std::uint32_t> root;  ///< for each vertex the first of those that it is joined with
  std::size_t opposed = 0;  ///< edges left open since their two faces run along them in the same direction
};

/// Joins vertices at one place as join() says. Faces with two corners at one place are looked through: their
/// neighbours meet.
/// \param place  for each vertex the first one at its place
Joined pair_and_join(const IndexedMesh& mesh, const std::vector<std::uint32_t>& place,
                     const JoinOptions& options);

}  // namespace whittle::files
