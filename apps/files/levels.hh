/// \file
/// Levels of detail in a glTF document: MSFT_lod.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

namespace whittle::files {

/// From which part of the screen's area on each level is shown: as long as the error of the next one would be larger than
/// a pixel of a screen of 1080 lines; 0 for the last. Empty where the errors do not grow from level to level.
/// \param diagonal  of the bounding box of what is shown
/// \param errors    of the levels, that of the first is 0; in the unit of the diagonal
std::vector<double> screen_coverage(double diagonal, const std::vector<double>& errors);

/// The coarser levels of a mesh of a document.
struct MeshLevels {
  std::vector<std::size_t> meshes;  ///< of the document, the finest of them first; empty: there are none
  std::vector<double> errors;       ///< of each, in the units of the mesh
  std::vector<double> coverage;     ///< as screen_coverage(), one more, or empty
};

/// Gives the nodes that show a mesh its levels. Such a node is hidden as a whole where a coarser level is shown; so if it
/// has children, a camera, extensions besides instancing, or is moved by an animation, its mesh goes to a new child. What
/// animates weights of morph targets does so for all levels.
/// \param levels  of each mesh of the document
void connect_levels(nlohmann::json& document, const std::vector<MeshLevels>& levels);

}  // namespace whittle::files
