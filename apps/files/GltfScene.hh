/// \file
/// Putting the pieces of a glTF scene into one mesh.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "files/GltfData.hh"
#include "files/MeshBuilder.hh"
#include "files/Scene.hh"
#include "files/gltf_document.hh"
#include "files/gltf_materials.hh"

namespace tinygltf {
struct Primitive;
}

namespace whittle::files {

/// Takes piece after piece; the vertices are those of the pieces, one piece after the other.
class GltfScene {
 public:
  /// \param kept  notes there where each piece is from, and takes all sets of all attributes; null: one mesh for other
  ///              formats, with the texture coordinates that materials take their base colours by
  GltfScene(MeshFile& file, MeshBuilder& builder, GltfData& data, Scene* kept, std::vector<TextureUse> uses)
      : file_(file), builder_(builder), data_(data), kept_(kept), uses_(std::move(uses)) {}

  /// \param object  what a part is called
  void add(const tinygltf::Primitive& primitive, const Eigen::Matrix4d& transform, const std::string& object);

  /// The mesh of the document, and which of its primitives, that comes next.
  void next(std::size_t mesh, std::size_t primitive) { piece_ = {mesh, primitive, {}}; }

  /// Hands the attributes over.
  void finish();

  /// Takes out what the pieces' buffers have besides the vertices of their faces; points stay. The file's numbers of
  /// vertices count all of them still.
  void drop_unused() const;

 private:
  /// The values of an attribute, one for each vertex of glTF so far.
  struct Channel {
    attributes::Attribute attribute;
    bool bytes = true;     ///< colours: all so far
    bool opacity = false;  ///< colours: some so far have four components
  };
  using Named = std::map<std::string, int>;

  void add_points(const std::vector<float>& points, const Eigen::Matrix4d& transform);
  void add_attributes(const tinygltf::Primitive& primitive, std::size_t count,
                      const Eigen::Matrix4d& transform);
  void add_attribute(const std::string& name, int accessor, std::size_t count,
                     const Eigen::Matrix4d& transform);
  void add_skin(const Named& accessors, std::size_t count);
  void add_target(const Named& accessors, std::size_t number, std::size_t count);
  Channel* channel_for(const std::string& name, std::size_t components);
  Channel& open(const std::string& name, const Channel& channel);
  std::string channel_name(const std::string& name) const;
  void transform_texture(std::vector<float>& values) const;
  void append(Channel& channel, const std::vector<float>& values, std::size_t components);
  void pad(Channel& channel, std::size_t values);
  void add_faces(const tinygltf::Primitive& primitive, std::size_t count, bool mirrored);
  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t count, bool mirrored);
  void add_part(std::uint32_t material, const std::string& object);

  MeshFile& file_;
  MeshBuilder& builder_;
  GltfData& data_;
  Scene* kept_;
  std::vector<TextureUse> uses_;
  TextureUse use_;  ///< of the piece at hand
  Scene::Piece piece_;
  std::size_t parts_ = 0;
  std::size_t begin_ = 0;  ///< the first vertex of the piece at hand
  std::map<std::string, Channel> channels_;
  std::vector<std::uint32_t> face_;
  std::vector<bool> stands_alone_;  ///< for each vertex whether it is there without a face
};

}  // namespace whittle::files
