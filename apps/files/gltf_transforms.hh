/// \file
/// Nodes that undo what is done to the coordinates of a mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "files/NodeAnimations.hh"

namespace whittle::files {

class MeshNodes {
 public:
  /// The document must outlive it.
  explicit MeshNodes(nlohmann::json& document);

  /// Lets the nodes that show a mesh scale it and then move it, before what they do already; once for each mesh.
  /// \param folds  they do it themselves; else each gets a child for it, so that what is said of them stays true
  /// \return null; else nothing has changed, and this says why: "has a skin"
  const char* move(std::size_t mesh, const Eigen::Vector3d& offset, double scale, bool folds);

 private:
  nlohmann::json& document_;
  NodeAnimations animations_;
  std::map<std::size_t, std::vector<std::size_t>> nodes_;  ///< that show each mesh
};

}  // namespace whittle::files
