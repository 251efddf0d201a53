/// \file
/// How times grow where very many faces meet in a vertex or an edge, or lie in one place.
#pragma once

#include <cstddef>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "terminal/Progress.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::speed {

struct Shape {
  std::string name;
  IndexedMesh mesh;
};

/// About so many faces each: a fan, one in a plane that is open, a bipyramid, a book of pages on one edge, a bouquet of pieces that touch in one
/// vertex, faces that coincide, a soup of lone faces, a grid in a plane.
std::vector<Shape> shapes(std::size_t n_faces);

/// Runs every module on each shape, with 20,000 and with 80,000 faces, and sets the times out in a table. A time in
/// proportion to the faces makes a ratio of 4; one in proportion to their square 16.
/// \param only  keeps the lines in which it is found
std::string shapes_page(const std::optional<std::regex>& only, terminal::Progress& progress);

}  // namespace whittle::speed
