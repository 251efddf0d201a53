#include "experiment/Environment.hh"

#include <ctime>
#include <fstream>
#include <thread>

#include "experiment/commit.hh"

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

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::string build_type() {
  return *WHITTLE_BUILD_TYPE != '\0' ? WHITTLE_BUILD_TYPE : "unknown";
}

}  // namespace

Environment environment(const egl::ContextFacts& gl) {
  return {
      gl.renderer,      gl.vendor,    gl.version, gl.device, cpu_model(), std::thread::hardware_concurrency(),
      WHITTLE_COMPILER, build_type(), kCommit,    kDirty,    now_utc()};
}

}  // namespace whittle::bench
