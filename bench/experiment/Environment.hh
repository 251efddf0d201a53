/// \file
/// What the time of a frame depends on besides the mesh.
#pragma once

#include "egl/EglContext.hh"
#include "experiment/Machine.hh"

namespace whittle::bench {

/// The machine and what draws on it.
struct Environment : Machine {
  egl::ContextFacts gl;
};

/// \param gl  of the context that draws.
inline Environment environment(const egl::ContextFacts& gl) {
  return {machine(), gl};
}

}  // namespace whittle::bench
