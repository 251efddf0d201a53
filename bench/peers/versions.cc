#include <meshoptimizer.h>

#include "peers/peers.hh"

namespace whittle::peers {

std::vector<std::pair<std::string, std::string>> versions() {
  std::vector<std::pair<std::string, std::string>> versions;
  versions.emplace_back("meshoptimizer", std::to_string(MESHOPTIMIZER_VERSION / 1000) + "." +
                                             std::to_string(MESHOPTIMIZER_VERSION / 10 % 100));
#ifdef WHITTLE_CGAL_VERSION
  versions.emplace_back("CGAL", WHITTLE_CGAL_VERSION);
#endif
#ifdef WHITTLE_VTK_VERSION
  versions.emplace_back("VTK", WHITTLE_VTK_VERSION);
#endif
  return versions;
}

}  // namespace whittle::peers
