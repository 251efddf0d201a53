/// \file
/// Larger models from smaller ones, to see how times grow.
#pragma once

#include "speed/Subject.hh"

namespace whittle::speed {

/// Every triangle cut into four at the middles of its edges. The new vertices then leave the surface by up to
/// a hundredth of their edge's length, along a direction that is a function of the edge's two indices alone:
/// the result is not exactly flat anywhere, the same on every machine, and as manifold as the input.
Arrays subdivide(const Arrays& arrays);

}  // namespace whittle::speed
