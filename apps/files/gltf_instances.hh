/// \file
/// EXT_mesh_gpu_instancing: a node that shows its mesh many times.
#pragma once

#include <vector>

#include "files/GltfData.hh"
#include "files/gltf_document.hh"

namespace whittle::files {

/// Each of them as often as it is shown.
/// \throw Fault  damaged, or more than may be made of the file
std::vector<GltfInstance> each_instance(const std::vector<GltfInstance>& instances, GltfData& data);

}  // namespace whittle::files
