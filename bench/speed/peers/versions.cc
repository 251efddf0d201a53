#include <meshoptimizer.h>

#include "speed/peers/peers.hh"

namespace whittle::speed {

std::vector<std::pair<std::string, std::string>> library_versions() {
  std::vector<std::pair<std::string, std::string>> versions;
  versions.emplace_back("meshoptimizer", std::to_string(MESHOPTIMIZER_VERSION / 1000) + "." +
                                             std::to_string(MESHOPTIMIZER_VERSION / 10 % 100));
#ifdef WHITTLE_WITH_CGAL
  versions.emplace_back("CGAL", WHITTLE_WITH_CGAL);
#endif
#ifdef WHITTLE_WITH_VTK
  versions.emplace_back("VTK", WHITTLE_WITH_VTK);
#endif
  return versions;
}

}  // namespace whittle::speed
