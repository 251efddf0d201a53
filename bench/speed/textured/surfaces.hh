/// \file
/// Surfaces that are made in code, with the texture coordinates or colours that they are born with.
#pragma once

#include <cstdint>
#include <functional>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::speed {

struct Painted {
  IndexedMesh mesh;
  attributes::Attribute paint;
};

/// A closed sphere of radius 1: a cube whose sides have n by n quads, blown up. Each side is a chart of its texture.
Painted sphere_in_six_charts(std::uint32_t n);

/// A relief z(x, y) over a rectangle from the origin, of two triangles a cell; the texture is the rectangle.
Painted relief(std::uint32_t columns, std::uint32_t rows, double width, double height,
               const std::function<double(double, double)>& z);

/// The same mesh with other texture coordinates, of the ones that the relief has.
Painted with_texture(Painted relief, const std::function<Eigen::Vector2d(double, double)>& texture);

/// The same mesh with colours, of the texture coordinates that the relief has.
Painted with_colours(const Painted& relief, const std::function<Eigen::Vector3d(double, double)>& colour);

}  // namespace whittle::speed
