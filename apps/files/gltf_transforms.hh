/// \file
/// Nodes that undo what is done to the coordinates of a mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace whittle::files {

/// Lets the nodes that show a mesh scale it and then move it, before what they do already.
/// \param folds  they do it themselves; else each gets a child for it, so that what is said of them stays true
/// \return null; else nothing has changed, and this says why: "has a skin"
const char* move_nodes(nlohmann::json& document, std::size_t mesh, const Eigen::Vector3d& offset,
                       double scale, bool folds);

/// Says that the document uses an extension and cannot be read without it.
void name_gltf_extension(nlohmann::json& document, const std::string& name);

}  // namespace whittle::files
