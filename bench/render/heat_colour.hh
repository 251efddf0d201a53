/// \file
/// The colours that stand for a figure.
#pragma once

#include <Eigen/Core>

namespace whittle::render {

/// Dark violet for 0, yellow for 1, by way of blue and green; beyond that the ends. Each step is brighter
/// than the one before, so the order survives print and colour blindness. Parts in [0, 1].
Eigen::Vector3f heat_colour(double value);

}  // namespace whittle::render
