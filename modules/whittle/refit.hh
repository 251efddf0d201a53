/// \file
/// The last step of a decimation: the vertices move to where the faces fit the original best.
#pragma once

#include "whittle/refit/refit.hh"  // IWYU pragma: export
