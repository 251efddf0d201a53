/// \file
/// What is done about a mesh that is not as it should be.
#pragma once

#include "files/MeshFile.hh"

namespace whittle::files {

/// Looks for what Repair names, repairs it where requested, and counts it in the report.
/// \pre every index is in range; coordinates are finite unless they are to be fixed
void repair(MeshFile& file, Repair mode);

}  // namespace whittle::files
