/// \file
/// Joining the pieces of a glTF scene into one mesh.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "files/GltfData.hh"
#include "files/MeshBuilder.hh"
#include "files/gltf_document.hh"

namespace tinygltf {
struct Primitive;
}

namespace whittle::files {

/// Takes piece after piece; the vertices are those of the pieces, one piece after the other.
class GltfScene {
 public:
  GltfScene(MeshFile& file, MeshBuilder& builder, GltfData& data)
      : file_(file), builder_(builder), data_(data) {}

  void add(const tinygltf::Primitive& primitive, const Eigen::Matrix4d& transform);

  /// Hands the attributes over.
  void finish();

 private:
  /// The values of an attribute, one for each vertex of glTF so far.
  struct Channel {
    attributes::Attribute attribute;
    bool bytes = true;     ///< colours: all so far
    bool opacity = false;  ///< colours: some so far have four components
  };

  void add_points(const std::vector<float>& points, const Eigen::Matrix4d& transform);
  void add_attribute(const std::string& name, int accessor, std::size_t count,
                     const Eigen::Matrix4d& transform);
  Channel* channel_for(const std::string& name, std::size_t components);
  void append(Channel& channel, const std::vector<float>& values, std::size_t components);
  void pad(Channel& channel, std::size_t values);
  void add_faces(const tinygltf::Primitive& primitive, std::size_t count, bool mirrored);
  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t count, bool mirrored);

  MeshFile& file_;
  MeshBuilder& builder_;
  GltfData& data_;
  std::size_t parts_ = 0;
  std::size_t begin_ = 0;  ///< the first vertex of the piece at hand
  std::map<std::string, Channel> channels_;
  std::vector<std::uint32_t> face_;
};

}  // namespace whittle::files
