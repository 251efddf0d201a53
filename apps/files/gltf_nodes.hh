/// \file
/// The scene of a glTF document: which meshes stand where.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "files/gltf_document.hh"

namespace whittle::files {

/// The list of objects of this name; an empty one where there is none.
/// \throw Fault  it is something else
nlohmann::json& gltf_objects(nlohmann::json& document, const char* key);

/// \throw Fault  it is missing or not a whole number of sensible size
std::size_t gltf_unsigned(const nlohmann::json& object, const char* key);

/// The meshes of the scene with their places; without scenes those of all nodes, without nodes all meshes.
/// \param keeps_scene  those of all nodes, and nothing is noted
/// \throw Fault  damaged; a node has two parents or is its own ancestor
std::vector<GltfInstance> read_gltf_nodes(nlohmann::json& document, bool keeps_scene, MeshBuilder& builder);

}  // namespace whittle::files
