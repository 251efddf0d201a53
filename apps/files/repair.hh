/// \file
/// What is done about a mesh that is not as it should be.
#pragma once

#include <vector>

#include "files/MeshFile.hh"
#include "measure/sides.hh"

namespace whittle::files {

/// What the looking begins with, where it has been found already; else nothing.
using Sides = std::vector<measure::Side>;

/// Looks for what Repair names, repairs it where requested, and counts it in the report.
/// \pre every index is in range; coordinates are finite unless they are to be fixed
/// \param sides  of the mesh's faces, or none
void repair(MeshFile& file, Repair mode, Sides sides = {});

}  // namespace whittle::files
