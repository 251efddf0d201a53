/// \file
/// Building a GLB with tinygltf.
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "files/Choice.hh"
#include "files/split.hh"

namespace whittle::files {

class GlbWriter {
 public:
  explicit GlbWriter(WriteReport& report) : report_(report) {
    model_.asset.version = "2.0";
    model_.asset.generator = "whittle";
    model_.buffers.resize(1);
    model_.scenes.resize(1);
    model_.defaultScene = 0;
  }

  /// Adds a mesh, a part of it for each material, and a node for it, which moves the mesh to its place where floats do not
  /// hold the coordinates; that of the first mesh moves all.
  /// \return the number of the node
  int add(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Parts& parts);

  tinygltf::Model& model() { return model_; }

  /// \throw Fault  more than 4 GiB
  std::string bytes();

 private:
  using Numbers = std::vector<float>;

  int add_mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Parts& parts);
  std::vector<std::uint32_t> add_part(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                                      tinygltf::Mesh& to);
  void add_materials(const Parts& parts);
  int add_image(const Image& image);
  int add_accessor(int component_type, int type, std::size_t count);
  int begin_view(int target, std::size_t stride);
  void end_view(int view);
  void append(float value);
  int add_floats(const Numbers& values, int type);
  int add_positions(const IndexedMesh& mesh, const Split& vertices);
  int add_colours(const attributes::Attribute& colour, const Split& vertices);
  int add_indices(const Split& vertices);

  WriteReport& report_;
  bool has_materials_ = false;
  IndexedMesh::Point origin_ = IndexedMesh::Point::Zero();
  tinygltf::Model model_;
};

}  // namespace whittle::files
