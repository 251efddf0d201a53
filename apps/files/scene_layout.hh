/// \file
/// Where the meshes of a glTF document are in the one mesh that is decimated.
#pragma once

#include <cstddef>
#include <vector>

#include "files/MeshFile.hh"
#include "files/Scene.hh"
#include "files/gltf_document.hh"

namespace whittle::files {

/// Puts the meshes beside each other, as Scene says.
/// \pre the points are in the coordinates of their meshes, and those of the file
void arrange(Scene& scene, const std::vector<GltfInstance>& instances, std::size_t meshes, MeshFile& file);

/// Makes parts of one material, but with different extensions of glTF, such as other variants of it, look different.
void tell_looks_apart(const Scene& scene, Parts& parts);

}  // namespace whittle::files
