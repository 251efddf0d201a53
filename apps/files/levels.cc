#include "files/levels.hh"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace whittle::files {
namespace {

using Json = nlohmann::json;

constexpr const char* kLevels = "MSFT_lod";
constexpr const char* kInstances = "EXT_mesh_gpu_instancing";
constexpr const char* kPointer = "KHR_animation_pointer";

/// A channel of an animation as far as it is about a node.
struct Animated {
  std::size_t node = 0;
  bool weights = false;  ///< of morph targets; else the node moves, or something unknown happens to it
};

std::optional<Animated> animated_by(const Json& target) {
  if (target.contains("node") && target["node"].is_number_unsigned())
    return Animated{target["node"].get<std::size_t>(), target.value("path", "") == "weights"};
  const Json::json_pointer place("/extensions/KHR_animation_pointer/pointer");
  if (!target.contains(place) || !target[place].is_string()) return std::nullopt;
  const std::string pointer = target[place].get<std::string>();
  const std::string beginning = "/nodes/";
  if (pointer.rfind(beginning, 0) != 0) return std::nullopt;
  const std::size_t end = pointer.find('/', beginning.size());
  const std::string number = pointer.substr(beginning.size(), end - beginning.size());
  if (number.empty() || number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  return Animated{std::stoul(number), end != std::string::npos && pointer.substr(end) == "/weights"};
}

Json aimed_at(Json target, std::size_t node) {
  if (target.contains("node"))
    target["node"] = node;
  else
    target["extensions"][kPointer]["pointer"] = "/nodes/" + std::to_string(node) + "/weights";
  return target;
}

class LevelNodes {
 public:
  LevelNodes(Json& document, const std::vector<MeshLevels>& levels)
      : document_(document), levels_(levels), is_moved_(document["nodes"].size(), false) {
    for_channels([&](Json&, const Json& channel) {
      const std::optional<Animated> animated = animated_by(channel["target"]);
      if (animated && !animated->weights && animated->node < is_moved_.size())
        is_moved_[animated->node] = true;
    });
  }

  void run() {
    bool any = false;
    for (std::size_t i = 0; i < is_moved_.size(); ++i) {
      const Json& node = document_["nodes"][i];
      if (!node.contains("mesh")) continue;
      const MeshLevels& levels = levels_[node["mesh"].get<std::size_t>()];
      if (levels.meshes.empty()) continue;
      const std::size_t shape = is_shape(i) ? i : move_to_child(i);
      give_levels(shape, levels);
      any = true;
    }
    if (any) use_extension();
  }

 private:
  /// \param use  called with the list of channels that is to be, and each channel
  template <typename Use>
  void for_channels(Use use) {
    if (!document_.contains("animations")) return;
    for (Json& animation : document_["animations"]) {
      if (!animation.contains("channels")) continue;
      Json out = Json::array();
      for (const Json& channel : animation["channels"]) {
        out.push_back(channel);
        if (channel.contains("target")) use(out, channel);
      }
      animation["channels"] = std::move(out);
    }
  }

  /// Whether all of a node may be hidden with its mesh. A skinned mesh stays where its joints are.
  bool is_shape(std::size_t number) const {
    const Json& node = document_["nodes"][number];
    if (node.contains("camera") || (node.contains("children") && !node["children"].empty())) return false;
    if (node.contains("extensions"))
      for (const auto& [name, value] : node["extensions"].items())
        if (name != kInstances) return false;
    return node.contains("skin") || !is_moved_[number];
  }

  std::size_t move_to_child(std::size_t number) {
    Json& nodes = document_["nodes"];
    Json& node = nodes[number];
    Json child;
    for (const char* key : {"mesh", "skin", "weights"}) move_member(node, child, key);
    if (node.contains("extensions")) {
      move_member(node["extensions"], child["extensions"], kInstances);
      if (child["extensions"].is_null()) child.erase("extensions");
      if (node["extensions"].empty()) node.erase("extensions");
    }
    const std::size_t place = nodes.size();
    node["children"].push_back(place);
    nodes.push_back(std::move(child));
    for_weights(number, [&](Json& channels) {
      channels.back()["target"] = aimed_at(channels.back()["target"], place);
    });
    return place;
  }

  static void move_member(Json& from, Json& to, const char* key) {
    if (!from.contains(key)) return;
    to[key] = std::move(from[key]);
    from.erase(key);
  }

  /// \param use  called with the list of channels that is to be, of which the last animates the weights of a node
  template <typename Use>
  void for_weights(std::size_t node, Use use) {
    for_channels([&](Json& channels, const Json& channel) {
      const std::optional<Animated> animated = animated_by(channel["target"]);
      if (animated && animated->weights && animated->node == node) use(channels);
    });
  }

  void give_levels(std::size_t number, const MeshLevels& levels) {
    Json& nodes = document_["nodes"];
    Json ids = Json::array();
    for (std::size_t i = 0; i < levels.meshes.size(); ++i) {
      Json level = nodes[number];
      for (const char* key : {"extras", "children"}) level.erase(key);
      if (level.contains("skin"))  // which says alone where it is
        for (const char* key : {"translation", "rotation", "scale", "matrix"}) level.erase(key);
      level["mesh"] = levels.meshes[i];
      level["extras"] = {{"error", levels.errors[i]}};
      if (level.contains("name") && level["name"].is_string())
        level["name"] = level["name"].get<std::string>() + "_LOD" + std::to_string(i + 1);
      ids.push_back(nodes.size());
      nodes.push_back(std::move(level));
    }
    Json& node = nodes[number];
    if (!levels.coverage.empty() && (!node.contains("extras") || node["extras"].is_object()))
      node["extras"]["MSFT_screencoverage"] = levels.coverage;
    for_weights(number, [&](Json& channels) {
      const Json original = channels.back();
      for (const Json& id : ids) {
        channels.push_back(original);
        channels.back()["target"] = aimed_at(original["target"], id.get<std::size_t>());
      }
    });
    node["extensions"][kLevels]["ids"] = std::move(ids);
  }

  void use_extension() {
    Json& used = document_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), kLevels) == used.end()) used.push_back(kLevels);
  }

  Json& document_;
  const std::vector<MeshLevels>& levels_;
  std::vector<bool> is_moved_;
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
