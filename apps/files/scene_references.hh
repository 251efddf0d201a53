/// \file
/// What of a glTF document's data is still needed when its triangles are replaced.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "files/Scene.hh"

namespace whittle::files {

/// For each accessor and each view of a document whether something names it.
struct SceneReferences {
  std::vector<bool> accessors, views;
};

/// Looks at animations, skins, instances, images, and at primitives that are not among the pieces. An extension that is
/// not known may name data by any whole number within it, so all of those count.
SceneReferences references_besides(const nlohmann::json& document, const std::vector<Scene::Piece>& pieces);

}  // namespace whittle::files
