#include "files/gltf_nodes.hh"

#include <Eigen/Geometry>
#include <algorithm>

#include "files/Fault.hh"

namespace whittle::files {
namespace {

using Json = nlohmann::json;
using Eigen::Matrix4d;

[[noreturn]] void throw_damaged(const std::string& key) {
  throw Fault("its JSON is damaged: wrong '" + key + "'");
}

std::size_t checked_index(const Json& number, std::size_t count, const char* key) {
  if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= count) throw_damaged(key);
  return number.get<std::size_t>();
}

/// A list of indices below `count`; empty where there is none.
std::vector<std::size_t> index_list(const Json& object, const char* key, std::size_t count) {
  std::vector<std::size_t> indices;
  const auto list = object.find(key);
  if (list == object.end()) return indices;
  if (!list->is_array()) throw_damaged(key);
  for (const Json& number : *list) indices.push_back(checked_index(number, count, key));
  return indices;
}

/// So many numbers; false where there are none.
bool read_numbers(const Json& node, const char* key, double* numbers, std::size_t count) {
  const auto list = node.find(key);
  if (list == node.end()) return false;
  if (!list->is_array() || list->size() != count) throw_damaged(key);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(*list)[i].is_number()) throw_damaged(key);
    numbers[i] = (*list)[i].get<double>();
  }
  return true;
}

Matrix4d transform_of(const Json& node) {
  Matrix4d matrix = Matrix4d::Identity();
  if (read_numbers(node, "matrix", matrix.data(), 16)) return matrix;
  double translation[3], rotation[4], scale[3];
  if (read_numbers(node, "rotation", rotation, 4))
    matrix.topLeftCorner<3, 3>() =
        Eigen::Quaterniond(rotation[3], rotation[0], rotation[1], rotation[2]).toRotationMatrix();
  if (read_numbers(node, "scale", scale, 3))
    for (int k = 0; k < 3; ++k) matrix.col(k) *= scale[k];
  if (read_numbers(node, "translation", translation, 3))
    for (int k = 0; k < 3; ++k) matrix(k, 3) = translation[k];
  return matrix;
}

std::string name_of(const Json& node) {
  const auto name = node.find("name");
  return name != node.end() && name->is_string() ? name->get<std::string>() : std::string();
}

class Walk {
 public:
  /// \param builder  for notes; null: nothing is noted
  Walk(const Json& nodes, std::size_t meshes, MeshBuilder* builder)
      : nodes_(nodes), meshes_(meshes), builder_(builder), seen_(nodes.size(), false) {}

  std::vector<GltfInstance> from(const std::vector<std::size_t>& roots) {
    push(roots, Matrix4d::Identity());
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      visit(next);
    }
    return std::move(instances_);
  }

  /// \pre all roots were walked from \throw Fault  a node is below itself, and so below no root
  void check_all_seen() const {
    if (std::find(seen_.begin(), seen_.end(), false) != seen_.end())
      throw Fault("its JSON is damaged: a node is below itself");
  }

 private:
  struct Waiting {
    std::size_t node;
    std::size_t parent;  ///< of the transforms
  };

  /// Seen before it waits, so that no node waits twice.
  void push(const std::vector<std::size_t>& nodes, const Matrix4d& transform) {
    if (nodes.empty()) return;
    transforms_.push_back(transform);
    for (std::size_t i = nodes.size(); i > 0; --i) {
      const std::size_t node = nodes[i - 1];
      if (seen_[node]) throw Fault("its JSON is damaged: a node is there twice");
      seen_[node] = true;
      waiting_.push_back({node, transforms_.size() - 1});
    }
  }

  void visit(const Waiting& next) {
    const Json& node = nodes_[next.node];
    const Matrix4d transform = transforms_[next.parent] * transform_of(node);
    if (const auto mesh = node.find("mesh"); mesh != node.end())
      instances_.push_back(
          {checked_index(*mesh, meshes_, "mesh"), transform, name_of(node), node.contains("skin")});
    if (const auto extensions = node.find("extensions"); extensions != node.end() && builder_)
      note(*extensions);
    push(index_list(node, "children", nodes_.size()), transform);
  }

  void note(const Json& extensions) {
    if (!extensions.is_object()) throw_damaged("extensions");
    for (const auto& [name, value] : extensions.items()) {
      if (name == "MSFT_lod" && value.is_object()) {
        const std::size_t levels = index_list(value, "ids", nodes_.size()).size();
        builder_->ignore(std::to_string(levels) + " coarser level" + (levels == 1 ? "" : "s") + " of detail");
      } else {
        builder_->ignore("extension " + in_quotes(name));
      }
    }
  }

  const Json& nodes_;
  std::size_t meshes_;
  MeshBuilder* builder_;
  std::vector<bool> seen_;
  std::vector<Matrix4d> transforms_;  ///< of the parents
  std::vector<Waiting> waiting_;
  std::vector<GltfInstance> instances_;
};

/// The root nodes.
std::vector<std::size_t> all_roots(const Json& nodes) {
  std::vector<bool> is_root(nodes.size(), true);
  for (const Json& node : nodes)
    for (const std::size_t child : index_list(node, "children", nodes.size())) is_root[child] = false;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < is_root.size(); ++i)
    if (is_root[i]) roots.push_back(i);
  return roots;
}

std::vector<GltfInstance> every_mesh(std::size_t meshes) {
  std::vector<GltfInstance> instances(meshes);
  for (std::size_t i = 0; i < meshes; ++i) instances[i].mesh = i;
  return instances;
}

}  // namespace

Json& gltf_objects(Json& document, const char* key) {
  Json& list = document[key];
  if (list.is_null()) list = Json::array();
  if (!list.is_array()) throw_damaged(key);
  for (const Json& object : list)
    if (!object.is_object()) throw_damaged(key);
  return list;
}

std::size_t gltf_unsigned(const Json& object, const char* key) {
  const auto number = object.find(key);
  if (number == object.end()) throw_damaged(key);
  return checked_index(*number, std::size_t{1} << 52, key);
}

std::vector<GltfInstance> read_gltf_nodes(Json& document, bool keeps_scene, MeshBuilder& builder) {
  const Json& nodes = gltf_objects(document, "nodes");
  const Json& scenes = gltf_objects(document, "scenes");
  const std::size_t meshes = gltf_objects(document, "meshes").size();
  Walk walk(nodes, meshes, keeps_scene ? nullptr : &builder);
  if (keeps_scene) {
    std::vector<GltfInstance> instances = walk.from(all_roots(nodes));
    walk.check_all_seen();
    return instances;
  }
  if (scenes.empty()) return nodes.empty() ? every_mesh(meshes) : walk.from(all_roots(nodes));
  const auto scene = document.find("scene");
  const std::size_t shown = scene == document.end() ? 0 : checked_index(*scene, scenes.size(), "scene");
  if (scenes.size() > 1) builder.ignore("other scenes");
  return walk.from(index_list(scenes[shown], "nodes", nodes.size()));
}

}  // namespace whittle::files
