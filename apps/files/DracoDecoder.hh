/// \file
/// Draco's decoders, which take memory only for what a file may take.
#pragma once

#include <draco/mesh/mesh.h>

#include <cstddef>
#include <memory>
#include <string_view>

namespace whittle::files {

/// What unpacking may take.
struct DracoLimits {
  std::size_t result_bytes = 0;   ///< indices, and all values of all points
  std::size_t working_bytes = 0;  ///< of the corner tables, while it unpacks
};

/// Unpacks a mesh. Draco takes memory by the counts that stand in the data, so they are looked at first.
/// \param limits  what is made is taken from `result_bytes`
/// \return the mesh; its faces may name points that are not there
/// \throw Fault  damaged, of another version than glTF wants, no mesh, or more than the limits
std::unique_ptr<draco::Mesh> decode_draco(std::string_view bytes, DracoLimits& limits);

}  // namespace whittle::files
