/// \file
/// What the animations of a glTF document do to its nodes.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace whittle::files {

class NodeAnimations {
 public:
  /// The document must outlive it.
  explicit NodeAnimations(nlohmann::json& document);

  /// Whether an animation moves a node, or does something unknown to it.
  bool move(std::size_t node) const { return moved_.count(node) > 0; }

  /// Lets what animates the weights of a node's morph targets animate those of others in its place.
  void aim_weights(std::size_t node, const std::vector<std::size_t>& at);

  /// Gives the mesh of a node, with its skin, weights and instances, to a new child.
  /// \return the child
  std::size_t move_mesh_to_child(std::size_t node);

 private:
  nlohmann::json& document_;
  std::set<std::size_t> moved_, weighed_;  ///< the latter: with weights that are animated
};

}  // namespace whittle::files
