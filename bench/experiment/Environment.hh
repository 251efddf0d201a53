/// \file
/// What the time of a frame depends on besides the mesh.
#pragma once

#include "egl/EglContext.hh"
#include "results/Results.hh"

namespace whittle::bench {

/// Facts of this machine, this build and this moment.
/// \param gl  of the context that draws.
Environment environment(const egl::ContextFacts& gl);

}  // namespace whittle::bench
