/// \file
/// The colours that stand for a figure.
#pragma once

#include <Eigen/Core>
#include <string>

namespace whittle::render {

/// Dark violet for 0, yellow for 1, by way of blue and green (the colours of viridis); beyond that the ends.
/// Each step is brighter than the one before, so the order survives print and colour blindness. Parts in [0,
/// 1].
Eigen::Vector3f heat_colour(double value);

/// The same as a function of a shader, `vec3 heat_colour(float value)`.
const std::string& heat_colour_shader();

}  // namespace whittle::render
