#include "files/GltfScene.hh"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "files/Fault.hh"
#include "files/settle.hh"

namespace whittle::files {
namespace {

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

void GltfScene::add(const tinygltf::Primitive& primitive, const Matrix4d& transform) {
  constexpr std::size_t bytes_of_a_part = 256;
  data_.charge(1, bytes_of_a_part);
  const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode == TINYGLTF_MODE_LINE || mode == TINYGLTF_MODE_LINE_LOOP || mode == TINYGLTF_MODE_LINE_STRIP) {
    builder_.ignore("lines");
    return;
  }
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) throw Fault("a part without positions");
  if (data_.components(position->second) != 3) throw Fault("positions of other than three coordinates");
  begin_ = file_.mesh.points.size();
  const std::vector<float> points = data_.floats(position->second);
  const std::size_t count = points.size() / 3;
  if (begin_ + count >= no_vertex) throw Fault("more vertices than 32-bit indices can name");
  add_points(points, transform);
  for (const auto& [name, accessor] : primitive.attributes)
    if (name != "POSITION") add_attribute(name, accessor, count, transform);
  for (auto& [name, channel] : channels_) pad(channel, file_.mesh.points.size());
  if (mode != TINYGLTF_MODE_POINTS)
    add_faces(primitive, count, transform.topLeftCorner<3, 3>().determinant() < 0);
  ++parts_;
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
  Channel* channel = channel_for(name, components);
  if (channel == nullptr) {
    builder_.ignore("attribute " + in_quotes(name));
    return;
  }
  if (data_.count(accessor) != count) throw Fault("attributes that are not as many as the vertices");
  std::vector<float> values = data_.floats(accessor);
  if (channel->attribute.kind == Kind::normal) turn_normals(values, transform);
  if (channel->attribute.kind == Kind::colour) {
    channel->bytes = channel->bytes && data_.are_bytes(accessor);
    channel->opacity = channel->opacity || components == 4;
  }
  append(*channel, values, components);
}

/// Null if it is not read.
GltfScene::Channel* GltfScene::channel_for(const std::string& name, std::size_t components) {
  Channel channel;
  Attribute& attribute = channel.attribute;
  if (name == "NORMAL" && components == 3) {
    attribute.kind = Kind::normal;
    attribute.components = 3;
  } else if (name == "TEXCOORD_0" && components == 2) {
    attribute.kind = Kind::texture;
    attribute.components = 2;
    attribute.downwards = true;
  } else if (name == "COLOR_0" && (components == 3 || components == 4)) {
    attribute.kind = Kind::colour;
    attribute.components = 4;  // until it is known whether any part has opacity
  } else if (name.size() > 1 && name[0] == '_' && components == 1) {
    attribute.name = name.substr(1);
  } else {
    return nullptr;
  }
  // Each takes a value for every vertex of the scene, so an absurd file must not have too many.
  constexpr std::size_t most = 32;
  const auto [place, is_new] = channels_.try_emplace(name, std::move(channel));
  if (is_new && channels_.size() > most) throw Fault("more than 32 attributes");
  if (is_new) pad(place->second, begin_);
  return &place->second;
}

void GltfScene::append(Channel& channel, const std::vector<float>& values, std::size_t components) {
  std::vector<float>& all = channel.attribute.values;
  const bool scalar = channel.attribute.kind == Kind::scalar;
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
  file_.report.missing_values += missing;
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

void GltfScene::finish() {
  if (parts_ > 1) file_.report.parts = parts_;
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
