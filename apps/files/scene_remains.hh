/// \file
/// What goes from a glTF document when its triangles are replaced.
#pragma once

#include <nlohmann/json.hpp>

#include "files/MeshFile.hh"
#include "files/Scene.hh"

namespace whittle::files {

/// Takes the materials out, or their textures, where what they are about has been left out.
/// \param attributes  of the result
void drop_lost_looks(nlohmann::json& document, const Scene& scene, bool has_materials,
                     const attributes::Attributes& attributes);

/// A part must have vertices, and a mesh must have parts: those that have none go, and nodes show them no more.
void drop_empty_meshes(nlohmann::json& document);

/// Extensions of how data are packed go with the data.
/// \param are_all_new  whether the data of all parts are
void drop_packing_extensions(nlohmann::json& document, bool are_all_new);

}  // namespace whittle::files
