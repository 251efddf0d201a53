#include "experiment/Machine.hh"

#include <sched.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "text/utc.hh"
#include "version/Version.hh"

namespace whittle::bench {
namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto value = line.find(": ");
    if (line.rfind("model name", 0) == 0 && value != std::string::npos) return line.substr(value + 2);
  }
  return "unknown";
}

/// Without what an affinity mask or a container takes away.
unsigned cpu_threads() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return std::thread::hardware_concurrency();
  return static_cast<unsigned>(CPU_COUNT(&allowed));
}

std::uint64_t memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) : 0;
}

std::string or_unknown(const std::string& text) {
  return text.empty() ? "unknown" : text;
}

}  // namespace

Machine machine() {
  return {
      cpu_model(),   cpu_threads(),     memory_bytes(),   WHITTLE_COMPILER, or_unknown(WHITTLE_BUILD_TYPE),
      WHITTLE_FLAGS, version::commit(), version::dirty(), text::now_utc()};
}

}  // namespace whittle::bench
