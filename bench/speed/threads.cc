#include "speed/threads.hh"

#include <sched.h>

#include <stdexcept>
#include <string>

namespace whittle::speed {
namespace {

cpu_set_t allowed() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0)
    throw std::runtime_error("the system does not tell which processors may be used");
  return set;
}

}  // namespace

unsigned allowed_threads() {
  const cpu_set_t set = allowed();
  return static_cast<unsigned>(CPU_COUNT(&set));
}

void confine(unsigned threads) {
  const cpu_set_t set = allowed();
  if (threads > allowed_threads())
    throw std::runtime_error("--threads: " + std::to_string(threads) + " are more than the " +
                             std::to_string(allowed_threads()) + " processors that may be used");
  cpu_set_t fewer;
  CPU_ZERO(&fewer);
  for (int cpu = 0; cpu < CPU_SETSIZE && static_cast<unsigned>(CPU_COUNT(&fewer)) < threads; ++cpu)
    if (CPU_ISSET(cpu, &set)) CPU_SET(cpu, &fewer);
  if (sched_setaffinity(0, sizeof fewer, &fewer) != 0)
    throw std::runtime_error("--threads: the system refuses");
}

}  // namespace whittle::speed
