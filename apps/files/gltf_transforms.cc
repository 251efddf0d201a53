#include "files/gltf_transforms.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace whittle::files {
namespace {

using Json = nlohmann::json;
using Eigen::Vector3d;

std::vector<std::size_t> nodes_showing(const Json& document, std::size_t mesh) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; document.contains("nodes") && i < document["nodes"].size(); ++i)
    if (document["nodes"][i].contains("mesh") && document["nodes"][i]["mesh"] == mesh) nodes.push_back(i);
  return nodes;
}

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

/// What animates the weights of morph targets names the node that has the mesh.
void move_weight_channels(Json& document, std::size_t from, std::size_t to) {
  if (!document.contains("animations")) return;
  for (Json& animation : document["animations"])
    for (Json& channel : animation.at("channels")) {
      Json& target = channel.at("target");
      if (target.value("path", "") == "weights" && target.contains("node") && target["node"] == from)
        target["node"] = to;
    }
}

void add_child(Json& document, std::size_t number, const Vector3d& offset, double scale) {
  Json child = {{"translation", list_of_three(offset)}, {"scale", list_of_three(Vector3d::Constant(scale))}};
  Json& node = document["nodes"][number];
  for (const char* key : {"mesh", "weights"}) {
    if (!node.contains(key)) continue;
    child[key] = std::move(node[key]);
    node.erase(key);
  }
  const std::size_t fresh = document["nodes"].size();
  node["children"].push_back(fresh);
  document["nodes"].push_back(std::move(child));
  move_weight_channels(document, number, fresh);
}

}  // namespace

const char* move_nodes(Json& document, std::size_t mesh, const Vector3d& offset, double scale, bool folds) {
  const std::vector<std::size_t> nodes = nodes_showing(document, mesh);
  if (nodes.empty()) return "is in no node";
  for (const std::size_t number : nodes) {
    const Json& node = document["nodes"][number];
    if (node.contains("skin")) return "has a skin";
    if (node.contains("extensions") && node["extensions"].contains("EXT_mesh_gpu_instancing"))
      return "has instances (EXT_mesh_gpu_instancing)";
  }
  for (const std::size_t number : nodes) {
    if (folds)
      fold(document["nodes"][number], offset, scale);
    else
      add_child(document, number, offset, scale);
  }
  return nullptr;
}

void name_gltf_extension(Json& document, const std::string& name) {
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    Json& list = document[key];
    if (list.is_null()) list = Json::array();
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  }
}

}  // namespace whittle::files
