#include "files/gltf_transforms.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;
using Eigen::Vector3d;

Json list_of_three(const Vector3d& numbers) {
  return {numbers.x(), numbers.y(), numbers.z()};
}

/// Of a node without rotation, as this program makes them.
void fold(Json& node, const Vector3d& offset, double scale) {
  Vector3d sum = offset;
  for (int k = 0; k < 3 && node.contains("translation"); ++k)
    sum[k] += node["translation"][static_cast<std::size_t>(k)].get<double>();
  node["translation"] = list_of_three(sum);
  node["scale"] = list_of_three(Vector3d::Constant(scale));
}

}  // namespace

MeshNodes::MeshNodes(Json& document) : document_(document), animations_(document) {
  for (std::size_t i = 0; document.contains("nodes") && i < document["nodes"].size(); ++i)
    if (document["nodes"][i].contains("mesh"))
      nodes_[document["nodes"][i]["mesh"].get<std::size_t>()].push_back(i);
}

const char* MeshNodes::move(std::size_t mesh, const Vector3d& offset, double scale, bool folds) {
  const auto shown = nodes_.find(mesh);
  if (shown == nodes_.end()) return "is in no node";
  for (const std::size_t number : shown->second) {
    const Json& node = document_["nodes"][number];
    if (node.contains("skin")) return "has a skin";
    if (node.contains("extensions") && node["extensions"].contains("EXT_mesh_gpu_instancing"))
      return "has instances (EXT_mesh_gpu_instancing)";
  }
  for (const std::size_t number : shown->second) {
    const std::size_t place = folds ? number : animations_.move_mesh_to_child(number);
    fold(document_["nodes"][place], offset, scale);
  }
  return nullptr;
}

}  // namespace whittle::files
