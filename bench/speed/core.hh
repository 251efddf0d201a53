/// \file
/// Which OpenMesh core library the program runs on.
#pragma once

#include <string>

namespace whittle::speed {

/// Debian's core is built with assertions; bench/speed/openmesh-core.sh builds the same without. Which of
/// them runs is decided when the program starts, so it is found out, not configured.
struct OpenMeshCore {
  std::string file;         ///< name of the library without its folder; "unknown" if it cannot be found out
  bool assertions = false;  ///< the library can call __assert_fail
  std::string label;        ///< "with assertions", "without assertions"
};

OpenMeshCore openmesh_core();

}  // namespace whittle::speed
