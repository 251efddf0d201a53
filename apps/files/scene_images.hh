/// \file
/// The images of a glTF scene that are files.
#pragma once

#include <filesystem>

#include "files/GltfOutput.hh"
#include "files/MeshFile.hh"
#include "files/Scene.hh"

namespace whittle::files {

/// Puts them into a GLB, or beside a .gltf. One that is missing or refused is noted, and its
/// name becomes one that leads to the same place from the result.
/// \param path  of the result
void carry_images(const Scene& scene, const std::filesystem::path& path, bool into_glb, GltfOutput& output,
                  Encoded& out);

}  // namespace whittle::files
