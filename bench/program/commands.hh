/// \file
/// The commands of whittle-bench. Each returns the exit code.
#pragma once

#include "program/CommandLine.hh"

namespace whittle::bench {

/// Lists EGL's devices with the renderers that they give.
int print_devices();

/// The benchmark.
/// \return 1 where a set could not be drawn.
/// \throw Stopped, SaveError, and what bad input throws
int run(const CommandLine& line);

/// Writes the report of results that are there.
int remake_report(const CommandLine& line);

}  // namespace whittle::bench
