/// \file
/// From where the model is seen: the pictures' cameras and those of the image difference.
#pragma once

#include <cstddef>
#include <vector>

#include "render/Camera.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

/// The two views of the pictures, the same for all sets: they come from the original's box.
struct Views {
  render::Camera whole;
  render::Camera ears;  ///< the upper front part of the box, where the bunny's ears are
};
Views views(const IndexedMesh& original, double aspect);

/// The first `count` of front, back, left, right, top, bottom and the eight corners of a cube.
/// \pre count <= kMostViews
std::vector<render::Camera> views_around(const IndexedMesh& original, std::size_t count);
constexpr std::size_t kMostViews = 14;

}  // namespace whittle::bench
