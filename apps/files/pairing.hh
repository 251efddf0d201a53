/// \file
/// Which vertices at one place belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

struct Joined {
  std::vector<std::uint32_t> root;  ///< for each vertex the first of those that it is joined with
  std::size_t opposed = 0;  ///< edges left open since their two faces run along them in the same direction
};

/// Joins vertices at one place as join() says.
/// \param place  for each vertex the first one at its place
/// Faces with two corners at one place are looked through: their neighbours meet.
Joined pair_and_join(const IndexedMesh& mesh, const std::vector<std::uint32_t>& place, bool turns);

}  // namespace whittle::files
