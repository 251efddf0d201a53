/// \file
/// What a time depends on besides the mesh.
#pragma once

#include <cstdint>
#include <string>

namespace whittle::bench {

/// Facts of the machine and the build. Whatever cannot be found out is "unknown", or 0 bytes.
struct Machine {
  std::string cpu_model;
  unsigned cpu_threads = 0;  ///< that this process may use
  std::uint64_t memory_bytes = 0;
  std::string compiler, build_type;
  std::string flags;          ///< what the compiler was given beside warnings
  std::string commit;         ///< of the source tree when the program was built
  bool commit_dirty = false;  ///< there were changes beside the commit
  std::string date_utc;       ///< ISO 8601
};

Machine machine();

}  // namespace whittle::bench
