/// \file
/// What a time depends on besides the mesh.
#pragma once

#include <string>

#include "egl/EglContext.hh"

namespace whittle::bench {

/// Facts of the machine and the build. Whatever cannot be found out is "unknown".
struct Environment {
  egl::ContextFacts gl;
  std::string cpu_model;
  unsigned cpu_threads = 0;  ///< that this process may use
  std::string compiler, build_type;
  std::string commit;         ///< of the source tree when the program was built
  bool commit_dirty = false;  ///< there were changes beside the commit
  std::string date_utc;       ///< ISO 8601
};

/// \param gl  of the context that draws.
Environment environment(const egl::ContextFacts& gl);

}  // namespace whittle::bench
