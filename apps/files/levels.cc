#include "files/levels.hh"

#include <algorithm>
#include <string>
#include <utility>

#include "files/NodeAnimations.hh"
#include "files/gltf_extensions.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;

constexpr const char* kLevels = "MSFT_lod";
constexpr const char* kInstances = "EXT_mesh_gpu_instancing";

class LevelNodes {
 public:
  LevelNodes(Json& document, const std::vector<MeshLevels>& levels)
      : document_(document), levels_(levels), animations_(document) {}

  void run() {
    bool any = false;
    const std::size_t n_nodes = document_["nodes"].size();
    for (std::size_t i = 0; i < n_nodes; ++i) {
      const Json& node = document_["nodes"][i];
      if (!node.contains("mesh")) continue;
      const MeshLevels& levels = levels_[node["mesh"].get<std::size_t>()];
      if (levels.meshes.empty()) continue;
      const std::size_t shape = is_shape(i) ? i : animations_.move_mesh_to_child(i);
      give_levels(shape, levels);
      any = true;
    }
    if (any) use_gltf_extension(document_, kLevels);
  }

 private:
  /// Whether all of a node may be hidden with its mesh. A skinned mesh stays where its joints are.
  bool is_shape(std::size_t number) const {
    const Json& node = document_["nodes"][number];
    if (node.contains("camera") || (node.contains("children") && !node["children"].empty())) return false;
    if (node.contains("extensions"))
      for (const auto& [name, value] : node["extensions"].items())
        if (name != kInstances) return false;
    return node.contains("skin") || !animations_.move(number);
  }

  void give_levels(std::size_t number, const MeshLevels& levels) {
    Json& nodes = document_["nodes"];
    std::vector<std::size_t> shapes = {number};
    for (std::size_t i = 0; i < levels.meshes.size(); ++i) {
      Json level = nodes[number];
      for (const char* key : {"extras", "children"}) level.erase(key);
      if (level.contains("skin"))  // which says alone where it is
        for (const char* key : {"translation", "rotation", "scale", "matrix"}) level.erase(key);
      level["mesh"] = levels.meshes[i];
      level["extras"] = {{"error", levels.errors[i]}};
      if (level.contains("name") && level["name"].is_string())
        level["name"] = level["name"].get<std::string>() + "_LOD" + std::to_string(i + 1);
      shapes.push_back(nodes.size());
      nodes.push_back(std::move(level));
    }
    Json& node = nodes[number];
    if (!levels.coverage.empty() && (!node.contains("extras") || node["extras"].is_object()))
      node["extras"]["MSFT_screencoverage"] = levels.coverage;
    node["extensions"][kLevels]["ids"] = std::vector<std::size_t>(shapes.begin() + 1, shapes.end());
    animations_.aim_weights(number, shapes);
  }

  Json& document_;
  const std::vector<MeshLevels>& levels_;
  NodeAnimations animations_;
};

}  // namespace

std::vector<double> screen_coverage(double diagonal, const std::vector<double>& errors) {
  constexpr double lines = 1080;
  std::vector<double> coverage;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    if (!(errors[i] > errors[i - 1]) || !(diagonal > 0)) return {};
    const double height = diagonal / (errors[i] * lines);  // of the screen's height
    coverage.push_back(std::min(1.0, height * height));
  }
  coverage.push_back(0);
  return coverage;
}

void connect_levels(Json& document, const std::vector<MeshLevels>& levels) {
  if (document.contains("nodes")) LevelNodes(document, levels).run();
}

}  // namespace whittle::files
