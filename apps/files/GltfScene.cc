#include "files/GltfScene.hh"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "files/Fault.hh"
#include "files/settle.hh"
#include "files/subset.hh"

namespace whittle::files {
namespace {

const std::string kTangents = "tangents, which programs make anew from normals and texture coordinates";

std::size_t to_size(int number) {
  return static_cast<std::size_t>(number);
}

/// "TEXCOORD_" and a number.
bool is_set(const std::string& name, const std::string& of) {
  return name.size() > of.size() && name.compare(0, of.size(), of) == 0 &&
         name.find_first_not_of("0123456789", of.size()) == std::string::npos;
}

bool is_skin(const std::string& name) {
  return is_set(name, "JOINTS_") || is_set(name, "WEIGHTS_");
}

using attributes::Attribute;
using attributes::Kind;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

/// What turns normals as the transform turns surfaces, with a scale that does not matter. Made of cofactors,
/// because a transform may have no inverse.
Matrix3d normal_transform(const Matrix4d& transform) {
  const Matrix3d linear = transform.topLeftCorner<3, 3>();
  Matrix3d cofactors;
  for (int k = 0; k < 3; ++k) cofactors.col(k) = linear.col((k + 1) % 3).cross(linear.col((k + 2) % 3));
  return linear.determinant() < 0 ? Matrix3d(-cofactors) : cofactors;
}

void turn_normals(std::vector<float>& normals, const Matrix4d& transform) {
  if (transform == Matrix4d::Identity()) return;
  const Matrix3d turn = normal_transform(transform);
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const Vector3d normal = (turn * Vector3d(normals[i], normals[i + 1], normals[i + 2])).stableNormalized();
    for (std::size_t k = 0; k < 3; ++k) normals[i + k] = static_cast<float>(normal[static_cast<int>(k)]);
  }
}

}  // namespace

void GltfScene::add(const tinygltf::Primitive& primitive, const Matrix4d& transform,
                    const std::string& object) {
  constexpr std::size_t bytes_of_a_part = 256;
  data_.charge(1, bytes_of_a_part);
  const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode == TINYGLTF_MODE_LINE || mode == TINYGLTF_MODE_LINE_LOOP || mode == TINYGLTF_MODE_LINE_STRIP) {
    if (!kept_) builder_.ignore("lines");
    return;
  }
  if (kept_ && mode == TINYGLTF_MODE_POINTS) return;
  const bool has_material = primitive.material >= 0 && to_size(primitive.material) < uses_.size();
  use_ = has_material ? uses_[to_size(primitive.material)] : TextureUse();
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) throw Fault("a part without positions");
  if (data_.components(position->second) != 3) throw Fault("positions of other than three coordinates");
  begin_ = file_.mesh.points.size();
  const std::vector<float> points = data_.floats(position->second);
  const std::size_t count = points.size() / 3;
  if (begin_ + count >= no_vertex) throw Fault("more vertices than 32-bit indices can name");
  add_points(points, transform);
  add_attributes(primitive, count, transform);
  for (auto& [name, channel] : channels_) pad(channel, file_.mesh.points.size());
  if (mode != TINYGLTF_MODE_POINTS)
    add_faces(primitive, count, transform.topLeftCorner<3, 3>().determinant() < 0);
  stands_alone_.resize(file_.mesh.points.size(), mode == TINYGLTF_MODE_POINTS);
  add_part(has_material ? static_cast<std::uint32_t>(primitive.material) : Part::none, object);
  ++parts_;
}

void GltfScene::add_part(std::uint32_t material, const std::string& object) {
  file_.parts.of_face.resize(file_.mesh.triangles.size(),
                             static_cast<std::uint32_t>(file_.parts.list.size()));
  file_.parts.list.push_back({material, object, "", ""});
  if (!kept_) return;
  for (std::size_t i = begin_; i < file_.mesh.points.size(); ++i)
    kept_->mesh_of.push_back(static_cast<std::uint32_t>(piece_.mesh));
  kept_->pieces.push_back(std::move(piece_));
}

void GltfScene::add_attributes(const tinygltf::Primitive& primitive, std::size_t count,
                               const Matrix4d& transform) {
  for (const auto& [name, accessor] : primitive.attributes)
    if (name != "POSITION" && !(kept_ && is_skin(name))) add_attribute(name, accessor, count, transform);
  if (!kept_) return;
  add_skin(primitive.attributes, count);
  for (std::size_t i = 0; i < primitive.targets.size(); ++i) add_target(primitive.targets[i], i, count);
}

/// JOINTS_n and WEIGHTS_n of all n together.
void GltfScene::add_skin(const Named& accessors, std::size_t count) {
  std::vector<std::vector<float>> joints, weights;
  for (;; joints.push_back(data_.floats(accessors.at("JOINTS_" + std::to_string(joints.size()))))) {
    const std::string number = std::to_string(joints.size());
    const auto joint = accessors.find("JOINTS_" + number), weight = accessors.find("WEIGHTS_" + number);
    if (joint == accessors.end() || weight == accessors.end()) break;
    if (data_.components(joint->second) != 4 || data_.components(weight->second) != 4 ||
        data_.count(joint->second) != count || data_.count(weight->second) != count)
      throw Fault("joints or weights that do not fit the vertices");
    weights.push_back(data_.floats(weight->second));
  }
  if (joints.empty()) return;
  const std::size_t components = 8 * joints.size();
  const std::string name = "skin " + std::to_string(joints.size());
  data_.charge(count, components * sizeof(float));
  Channel fresh;
  fresh.attribute.kind = Kind::skin;
  fresh.attribute.name = name;
  fresh.attribute.components = components;
  std::vector<float>& all = open(name, fresh).attribute.values;
  for (std::size_t i = 0; i < 4 * count; i += 4)
    for (std::size_t set = 0; set < joints.size(); ++set)
      for (std::size_t k = 0; k < 4; ++k)
        all.insert(all.end(), {joints[set][i + k], builder_.component(weights[set][i + k])});
  piece_.channels.push_back({name, components, false});
}

/// What a morph target adds to the vertices.
void GltfScene::add_target(const Named& accessors, std::size_t number, std::size_t count) {
  for (const auto& [name, accessor] : accessors) {
    if (name == "TANGENT") {
      builder_.ignore_besides(kTangents);
      continue;
    }
    const std::size_t components = data_.components(accessor);
    if (data_.count(accessor) != count) throw Fault("a morph target that does not fit the vertices");
    const std::string full = std::to_string(number) + "/" + name;
    Channel fresh;
    fresh.attribute.kind = Kind::vector;
    fresh.attribute.name = full;
    fresh.attribute.components = components;
    Channel& channel = open(full, fresh);
    if (channel.attribute.components != components) {
      builder_.ignore("morph target " + in_quotes(full));
      continue;
    }
    append(channel, data_.floats(accessor), components);
    piece_.channels.push_back({full, components, false});
  }
}

void GltfScene::add_points(const std::vector<float>& points, const Matrix4d& transform) {
  const bool stays = transform == Matrix4d::Identity();
  file_.single_precision = (file_.single_precision || parts_ == 0) && stays;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    Vector3d point(points[i], points[i + 1], points[i + 2]);
    if (!stays) point = transform.topLeftCorner<3, 3>() * point + transform.topRightCorner<3, 1>();
    builder_.add_point(point.x(), point.y(), point.z());
  }
}

void GltfScene::add_attribute(const std::string& name, int accessor, std::size_t count,
                              const Matrix4d& transform) {
  const std::size_t components = data_.components(accessor);
  Channel* channel = channel_for(channel_name(name), components);
  if (channel == nullptr) {
    builder_.ignore_besides(name == "TANGENT" ? kTangents : "attribute " + in_quotes(name));
    return;
  }
  if (data_.count(accessor) != count) throw Fault("attributes that are not as many as the vertices");
  std::vector<float> values = data_.floats(accessor);
  if (channel->attribute.kind == Kind::normal) turn_normals(values, transform);
  if (channel->attribute.kind == Kind::colour) {
    channel->bytes = channel->bytes && data_.are_bytes(accessor);
    channel->opacity = channel->opacity || components == 4;
  }
  if (channel->attribute.kind == Kind::texture && !kept_) transform_texture(values);
  if (channel->attribute.names && !data_.are_whole(accessor)) channel->attribute.names = false;
  append(*channel, values, components);
  piece_.channels.push_back({name, components, data_.are_bytes(accessor)});
}

/// For other formats the set that the base colour is taken by is the first.
std::string GltfScene::channel_name(const std::string& name) const {
  if (kept_ || name.rfind("TEXCOORD_", 0) != 0) return name;
  return name == "TEXCOORD_" + std::to_string(use_.set) ? "TEXCOORD_0" : "";
}

void GltfScene::transform_texture(std::vector<float>& values) const {
  if (use_.is_plain()) return;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
    const Eigen::Vector2d moved =
        use_.transform * Vector3d(static_cast<double>(values[i]), static_cast<double>(values[i + 1]), 1);
    values[i] = static_cast<float>(moved.x());
    values[i + 1] = static_cast<float>(moved.y());
  }
}

/// Null if it is not read.
GltfScene::Channel* GltfScene::channel_for(const std::string& name, std::size_t components) {
  Channel channel;
  Attribute& attribute = channel.attribute;
  if (name == "NORMAL" && components == 3) {
    attribute.kind = Kind::normal;
    attribute.components = 3;
  } else if (is_set(name, "TEXCOORD_") && components == 2) {
    attribute.kind = Kind::texture;
    attribute.components = 2;
    attribute.downwards = true;
  } else if (is_set(name, "COLOR_") && (components == 3 || components == 4)) {
    attribute.kind = Kind::colour;
    attribute.components = 4;  // until it is known whether any part has opacity
  } else if (name.size() > 1 && name[0] == '_' && (components == 1 || kept_)) {
    attribute.kind = components == 1 ? Kind::scalar : Kind::vector;
    attribute.components = components;
    attribute.name = name.substr(1);
    attribute.names = kept_ != nullptr;  // until one is not a whole number
  } else {
    return nullptr;
  }
  if (kept_)
    attribute.name = name;
  else if (attribute.name.empty() && name != "NORMAL" && name != "TEXCOORD_0" && name != "COLOR_0")
    return nullptr;
  Channel& opened = open(name, channel);
  const bool fits = opened.attribute.kind == Kind::colour || opened.attribute.components == components;
  return fits ? &opened : nullptr;
}

/// The channel of this name; the one given where there is none yet.
GltfScene::Channel& GltfScene::open(const std::string& name, const Channel& channel) {
  // Each takes a value for every vertex of the scene, so an absurd file must not have too many.
  const std::size_t most = kept_ ? 1024 : 32;
  const auto [place, is_new] = channels_.try_emplace(name, channel);
  if (is_new && channels_.size() > most) throw Fault("more than " + std::to_string(most) + " attributes");
  if (is_new) pad(place->second, begin_);
  return place->second;
}

void GltfScene::append(Channel& channel, const std::vector<float>& values, std::size_t components) {
  std::vector<float>& all = channel.attribute.values;
  const bool scalar = channel.attribute.kind == Kind::scalar;
  data_.charge(values.size() / components, sizeof(float) * channel.attribute.components);
  for (std::size_t i = 0; i < values.size(); i += components) {
    for (std::size_t k = 0; k < channel.attribute.components; ++k) {
      if (k >= components)
        all.push_back(1.0F);
      else
        all.push_back(scalar ? values[i + k] : builder_.component(values[i + k]));
    }
  }
}

/// Gives the vertices up to a number a value if they have none.
void GltfScene::pad(Channel& channel, std::size_t values) {
  Attribute& attribute = channel.attribute;
  const std::size_t missing = values - attribute.n_values();
  if (missing == 0) return;
  data_.charge(missing, attribute.components * sizeof(float));
  if (!kept_) file_.report.missing_values += missing;
  attribute.values.insert(attribute.values.end(), missing * attribute.components,
                          default_component(attribute.kind));
}

void GltfScene::add_faces(const tinygltf::Primitive& primitive, std::size_t count, bool mirrored) {
  std::vector<std::uint32_t> all;
  const bool indexed = primitive.indices >= 0;
  if (indexed) all = data_.indices(primitive.indices);
  const std::size_t corners = indexed ? all.size() : count;
  const auto corner = [&](std::size_t i) { return indexed ? all[i] : static_cast<std::uint32_t>(i); };
  switch (primitive.mode) {
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      for (std::size_t i = 0; i + 2 < corners; ++i)
        add_face(corner(i), corner(i + 1 + i % 2), corner(i + 2 - i % 2), count, mirrored);
      break;
    case TINYGLTF_MODE_TRIANGLE_FAN:
      for (std::size_t i = 1; i + 1 < corners; ++i)
        add_face(corner(i), corner(i + 1), corner(0), count, mirrored);
      break;
    case TINYGLTF_MODE_TRIANGLES:
    case -1:
      if (corners % 3 != 0) throw Fault("a number of corners that makes no triangles");
      for (std::size_t i = 0; i < corners; i += 3)
        add_face(corner(i), corner(i + 1), corner(i + 2), count, mirrored);
      break;
    default:
      throw Fault("a part of an unknown kind");
  }
}

/// \param count  vertices of the piece at hand, from which the corners count
void GltfScene::add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t count,
                         bool mirrored) {
  if (mirrored) std::swap(b, c);
  face_.clear();
  for (const std::uint32_t corner : {a, b, c}) {
    const std::uint32_t known = builder_.index(corner, count);
    face_.push_back(known == no_vertex ? no_vertex : static_cast<std::uint32_t>(begin_ + known));
  }
  builder_.add_face(face_);
}

void GltfScene::drop_unused() const {
  std::vector<bool> keep = stands_alone_;
  for (const IndexedMesh::Triangle& triangle : file_.mesh.triangles)
    for (const std::uint32_t vertex : triangle) keep[vertex] = true;
  keep_vertices(file_, keep);
}

void GltfScene::finish() {
  if (parts_ > 1 && !kept_) file_.report.parts = parts_;
  for (auto& [name, channel] : channels_) {
    Attribute& attribute = channel.attribute;
    if (attribute.kind == Kind::colour) {
      attribute.bytes = channel.bytes;
      if (!channel.opacity) {
        std::vector<float> opaque;
        for (std::size_t i = 0; i < attribute.values.size(); ++i)
          if (i % 4 < 3) opaque.push_back(attribute.values[i]);
        attribute.values = std::move(opaque);
        attribute.components = 3;
      }
    }
    file_.attributes.push_back(std::move(attribute));
  }
}

}  // namespace whittle::files
