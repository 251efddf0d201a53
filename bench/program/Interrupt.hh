/// \file
/// Ctrl-C ends the benchmark between two frames, so that no file is left half written.
#pragma once

namespace whittle::bench {

/// From now on SIGINT and SIGTERM only set a flag.
void catch_interrupts();

/// The signal that came, or 0.
int interrupt_signal();

}  // namespace whittle::bench
