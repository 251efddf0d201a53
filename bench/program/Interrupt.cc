#include "program/Interrupt.hh"

#include <csignal>

namespace whittle::bench {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t caught = 0;

void note(int signal) {
  caught = signal;
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

int interrupt_signal() {
  return caught;
}

}  // namespace whittle::bench
