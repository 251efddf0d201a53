#include "files/NodeAnimations.hh"

#include <optional>
#include <string>
#include <utility>

namespace whittle::files {
namespace {

using Json = nlohmann::json;

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

void move_member(Json& from, Json& to, const char* key) {
  if (!from.contains(key)) return;
  to[key] = std::move(from[key]);
  from.erase(key);
}

/// \param use  called with each channel that has a target
template <typename Use>
void for_each_channel(const Json& document, Use use) {
  if (!document.contains("animations")) return;
  for (const Json& animation : document["animations"])
    if (animation.contains("channels"))
      for (const Json& channel : animation["channels"])
        if (channel.contains("target")) use(channel);
}

}  // namespace

NodeAnimations::NodeAnimations(Json& document) : document_(document) {
  for_each_channel(document_, [&](const Json& channel) {
    if (const std::optional<Animated> animated = animated_by(channel["target"]))
      (animated->weights ? weighed_ : moved_).insert(animated->node);
  });
}

void NodeAnimations::aim_weights(std::size_t node, const std::vector<std::size_t>& at) {
  if (weighed_.erase(node) == 0) return;
  weighed_.insert(at.begin(), at.end());
  for (Json& animation : document_["animations"]) {
    if (!animation.contains("channels")) continue;
    Json channels = Json::array();
    for (const Json& channel : animation["channels"]) {
      const std::optional<Animated> animated =
          channel.contains("target") ? animated_by(channel["target"]) : std::nullopt;
      if (!animated || !animated->weights || animated->node != node) {
        channels.push_back(channel);
        continue;
      }
      for (const std::size_t other : at) {
        channels.push_back(channel);
        channels.back()["target"] = aimed_at(channel["target"], other);
      }
    }
    animation["channels"] = std::move(channels);
  }
}

std::size_t NodeAnimations::move_mesh_to_child(std::size_t node) {
  constexpr const char* instances = "EXT_mesh_gpu_instancing";
  Json& nodes = document_["nodes"];
  Json& parent = nodes[node];
  Json child;
  for (const char* key : {"mesh", "skin", "weights"}) move_member(parent, child, key);
  if (parent.contains("extensions")) {
    move_member(parent["extensions"], child["extensions"], instances);
    if (child["extensions"].is_null()) child.erase("extensions");
    if (parent["extensions"].empty()) parent.erase("extensions");
  }
  const std::size_t place = nodes.size();
  parent["children"].push_back(place);
  nodes.push_back(std::move(child));
  aim_weights(node, {place});
  return place;
}

}  // namespace whittle::files
