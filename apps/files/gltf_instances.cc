#include "files/gltf_instances.hh"

#include <Eigen/Geometry>
#include <algorithm>

#include "files/Fault.hh"

namespace whittle::files {
namespace {

/// The values of an attribute of the instances; none where there is no such accessor.
std::vector<float> values_of_instances(int accessor, std::size_t components, GltfData& data) {
  if (accessor < 0) return {};
  if (data.components(accessor) != components) throw Fault("instances have values of the wrong kind");
  return data.floats(accessor);
}

/// The three numbers of an instance, or the same three where there are none of any.
Eigen::Vector3d three_of(const std::vector<float>& values, std::size_t instance, double otherwise) {
  if (values.empty()) return Eigen::Vector3d::Constant(otherwise);
  return Eigen::Map<const Eigen::Vector3f>(values.data() + 3 * instance).cast<double>();
}

void add_instances(const GltfInstance& node, GltfData& data, std::vector<GltfInstance>& out) {
  std::size_t count = 0;
  for (const int accessor : {node.places.translation, node.places.rotation, node.places.scale})
    if (accessor >= 0) count = data.count(accessor);
  data.charge(count, sizeof(GltfInstance));
  const std::vector<float> moved = values_of_instances(node.places.translation, 3, data),
                           turned = values_of_instances(node.places.rotation, 4, data),
                           scaled = values_of_instances(node.places.scale, 3, data);
  for (const auto& [values, components] :
       {std::pair(&moved, 3U), std::pair(&turned, 4U), std::pair(&scaled, 3U)})
    if (!values->empty() && values->size() != components * count)
      throw Fault("instances have values of different number");
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Affine3d place(Eigen::Translation3d(three_of(moved, i, 0)));
    if (!turned.empty()) {
      const float* q = turned.data() + 4 * i;
      place.rotate(Eigen::Quaterniond(double{q[3]}, double{q[0]}, double{q[1]}, double{q[2]}));
    }
    place.scale(three_of(scaled, i, 1));
    out.push_back(node);
    out.back().places = {};
    out.back().transform = node.transform * place.matrix();
  }
}

}  // namespace

std::vector<GltfInstance> each_instance(const std::vector<GltfInstance>& instances, GltfData& data) {
  std::vector<GltfInstance> out;
  for (const GltfInstance& instance : instances) {
    if (instance.places.any())
      add_instances(instance, data, out);
    else
      out.push_back(instance);
  }
  return out;
}

}  // namespace whittle::files
