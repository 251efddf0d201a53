/// \file
/// Building a glTF document of meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "files/Choice.hh"
#include "files/GltfOutput.hh"
#include "files/split.hh"

namespace whittle::files {

/// Makes a new document with one scene, which shows the first mesh that is added.
class GltfWriter {
 public:
  explicit GltfWriter(WriteReport& report);

  /// Adds a mesh, a part of it for each material, and a node for it, which moves the mesh to its place where floats do not
  /// hold the coordinates; that of the first mesh moves all. The materials are those of the first mesh, too.
  /// \return the number of the node
  std::size_t add(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Parts& parts);

  GltfOutput& output() { return output_; }

 private:
  using Json = GltfOutput::Json;

  Json mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Parts& parts);
  Json primitive(const IndexedMesh& mesh, const attributes::Attributes& attributes, std::uint32_t material,
                 std::vector<std::uint32_t>& first, std::size_t& count);
  void add_materials(const Parts& parts);
  std::optional<std::size_t> add_image(const Image& image);
  std::size_t add_positions(const IndexedMesh& mesh, const Split& vertices);
  std::size_t add_texture(const attributes::Attribute& texture, const Split& vertices);
  std::size_t add_colours(const attributes::Attribute& colour, const Split& vertices);
  void add_scalars(const std::vector<const attributes::Attribute*>& scalars, const Split& vertices, Json& to);

  WriteReport& report_;
  IndexedMesh::Point origin_ = IndexedMesh::Point::Zero();
  GltfOutput output_;
};

}  // namespace whittle::files
